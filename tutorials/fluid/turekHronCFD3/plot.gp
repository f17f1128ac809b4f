# History of the last seconds; the lines are the reference's mean +- amplitude
set terminal pngcairo size 700,440
set output "turekHronCFD3.png"
set xlabel "t [s]"
set xrange [7:10]
set key off
set multiplot layout 2, 1

set ylabel "drag [N/m]"
plot "< mfCompare -series forces" using 1:($2) with lines, \
    445.068 with lines dashtype 2 linecolor 0, \
    433.832 with lines dashtype 2 linecolor 0

set ylabel "lift [N/m]"
plot "< mfCompare -series forces" using 1:($3) with lines, \
    425.917 with lines dashtype 2 linecolor 0, \
    -449.703 with lines dashtype 2 linecolor 0

unset multiplot
