# Forces on the wings, flexible and rigid, and the worst element
set terminal pngcairo size 700,640
set output "flappingWing.png"
set xlabel "t [s]"
set xrange [0.1:6.5]
set multiplot layout 3, 1
rigid = "../flappingWing.rigid"

set ylabel "along [N]"
plot "< mfCompare -series forces" using 1:2 with lines title "flexible", \
    "< mfCompare -case ".rigid." -series forces" using 1:2 with lines dashtype 2 title "rigid"

set ylabel "across [N]"
plot "< mfCompare -series forces" using 1:3 with lines title "flexible", \
    "< mfCompare -case ".rigid." -series forces" using 1:3 with lines dashtype 2 title "rigid"

set ylabel "least angle [degrees]"
set yrange [0:10]
set key off
plot "< mfCompare -series quality" using 1:7 with lines, 3 with lines dashtype 2 linecolor 0

unset multiplot
