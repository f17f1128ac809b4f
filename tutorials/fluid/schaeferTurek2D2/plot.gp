# Coefficients 2 F/(rho U^2 D) of the last seconds; the lines are the maxima published
set terminal pngcairo size 700,440
set output "schaeferTurek2D2.png"
set xlabel "t [s]"
set xrange [8:10]
set key off
set multiplot layout 2, 1

set ylabel "drag coefficient"
plot "< mfCompare -series forces" using 1:(20*$2) with lines, \
    3.22 with lines dashtype 2 linecolor 0, \
    3.24 with lines dashtype 2 linecolor 0

set ylabel "lift coefficient"
plot "< mfCompare -series forces" using 1:(20*$3) with lines, \
    0.99 with lines dashtype 2 linecolor 0, \
    1.01 with lines dashtype 2 linecolor 0

unset multiplot
