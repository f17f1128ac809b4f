# History of the last seconds; the lines are the reference's mean +- amplitude
set terminal pngcairo size 600,760
set output "turekHronFSI3.png"
set xlabel "t [s]"
set xrange [7:8]
set key off
set multiplot layout 4, 1

set ylabel "Dx [mm]"
plot "< mfCompare -series tip" using 1:(1e3*$2) with lines, \
    -0.16 with lines dashtype 2 linecolor 0, \
    -5.6 with lines dashtype 2 linecolor 0

set ylabel "Dy [mm]"
plot "< mfCompare -series tip" using 1:(1e3*$3) with lines, \
    36.46 with lines dashtype 2 linecolor 0, \
    -33.52 with lines dashtype 2 linecolor 0

set ylabel "drag [N/m]"
plot "< mfCompare -series forces" using 1:($2) with lines, \
    488.24 with lines dashtype 2 linecolor 0, \
    432.76 with lines dashtype 2 linecolor 0

set ylabel "lift [N/m]"
plot "< mfCompare -series forces" using 1:($3) with lines, \
    156.41 with lines dashtype 2 linecolor 0, \
    -151.41 with lines dashtype 2 linecolor 0

unset multiplot
