# Coefficients 2 F/(rho U^2 D 4 m) over time; the lines are the mean drag of experiment and DNS
set terminal pngcairo size 700,440
set output "squareCylinderLES.png"
set xlabel "t U/D"
set key off
set multiplot layout 2, 1

set ylabel "drag coefficient"
set yrange [1:3.5]
plot "< mfCompare -series forces" using 1:(0.5*$2) with lines, \
    2.1 with lines dashtype 2 linecolor 0, \
    2.18 with lines dashtype 3 linecolor 0

set ylabel "lift coefficient"
set yrange [-3:3]
plot "< mfCompare -series forces" using 1:(0.5*$3) with lines

unset multiplot
