# Torque on the plate, on the mesh with exchanges and on the one that turns as a
# whole, and the difference
set terminal pngcairo size 700,440
set output "rotatingPlate.png"
set xlabel "t [s]"
set multiplot layout 2, 1

set ylabel "torque [N m/m]"
plot "< mfCompare -series forces" using 1:($7) with lines title "exchanges", \
    "< mfCompare -case ../rotatingPlate.rigid -series forces" using 1:($7) with lines dashtype 2 title "whole mesh turns"

set ylabel "difference [N m/m]"
set key off
plot "< bash -c 'paste <(mfCompare -series forces) <(mfCompare -case ../rotatingPlate.rigid -series forces)'" using 1:($7 - $14) with lines

unset multiplot
