# History of the last seconds; the lines are the reference's mean +- amplitude
set terminal pngcairo size 700,440
set output "turekHronCSM3.png"
set xlabel "t [s]"
set xrange [0:10]
set key off
set multiplot layout 2, 1

set ylabel "Dx [mm]"
plot "< mfCompare -series tip" using 1:(1e3*$2) with lines, \
    0 with lines dashtype 2 linecolor 0, \
    -28.61 with lines dashtype 2 linecolor 0

set ylabel "Dy [mm]"
plot "< mfCompare -series tip" using 1:(1e3*$3) with lines, \
    1.553 with lines dashtype 2 linecolor 0, \
    -128.767 with lines dashtype 2 linecolor 0

unset multiplot
