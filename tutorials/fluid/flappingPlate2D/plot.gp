# Forces on the plate, and the worst element
set terminal pngcairo size 700,440
set output "flappingPlate2D.png"
set xlabel "t [s]"
set xrange [0.1:6.5]
set multiplot layout 2, 1

set ylabel "force [N/m]"
plot "< mfCompare -series forces" using 1:2 with lines title "along", \
    "< mfCompare -series forces" using 1:3 with lines title "across"

set ylabel "least scaled Jacobian"
set key off
plot "< mfCompare -series quality" using 1:3 with lines, 0.15 with lines dashtype 2 linecolor 0

unset multiplot
