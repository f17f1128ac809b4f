# History of the last seconds; the lines are the reference's mean +- amplitude
set terminal pngcairo size 600,760
set output "turekHronFSI2.png"
set xlabel "t [s]"
set xrange [12:15]
set key off
set multiplot layout 4, 1

set ylabel "Dx [mm]"
plot "< mfCompare -series tip" using 1:(1e3*$2) with lines, \
    -2.15 with lines dashtype 2 linecolor 0, \
    -27.55 with lines dashtype 2 linecolor 0

set ylabel "Dy [mm]"
plot "< mfCompare -series tip" using 1:(1e3*$3) with lines, \
    82.9 with lines dashtype 2 linecolor 0, \
    -80.3 with lines dashtype 2 linecolor 0

set ylabel "drag [N/m]"
plot "< mfCompare -series forces" using 1:($2) with lines, \
    292.71 with lines dashtype 2 linecolor 0, \
    137.41 with lines dashtype 2 linecolor 0

set ylabel "lift [N/m]"
plot "< mfCompare -series forces" using 1:($3) with lines, \
    238.41 with lines dashtype 2 linecolor 0, \
    -237.19 with lines dashtype 2 linecolor 0

unset multiplot
