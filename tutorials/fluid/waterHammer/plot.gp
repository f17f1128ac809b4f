# Pressure at the valve
set terminal pngcairo size 700,300
set output "waterHammer.png"
set xlabel "t [s]"
set ylabel "p [Pa]"
set key off
plot "< mfCompare -series valve" using 1:2 with lines, \
    10000 with lines dashtype 2 linecolor 0, -10000 with lines dashtype 2 linecolor 0
