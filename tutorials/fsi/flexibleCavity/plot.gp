# History of the middle of the bottom; the lines are the reference's extremes
set terminal pngcairo size 700,300
set output "flexibleCavity.png"
set xlabel "t [s]"
set ylabel "Dy [m]"
set key off
plot "< mfCompare -series middle" using 1:3 with lines, \
    0.2861 with lines dashtype 2 linecolor 0, \
    0.2044 with lines dashtype 2 linecolor 0
