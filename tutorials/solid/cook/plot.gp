# Deflection of the tip over the number of cells along a side
set terminal pngcairo size 600,400
set output "cook.png"
set xlabel "cells along a side"
set ylabel "deflection of the tip [mm]"
set logscale x 2
set xrange [7:80]
set key bottom right
tip(cases) = sprintf("< for c in %s; do n=${c##*:}; echo $n $(tail -1 ../${c%%:*}/postProcessing/solid/tip/0/*.dat); done", cases)
plot 6.931 with lines linetype -1 title "converged", \
    tip("cook:16") using 1:($4*1000) with points pointtype 7 title "Q2Q1", \
    tip("cook.P2P1:32") using 1:($4*1000) with points pointtype 5 title "P2P1", \
    tip("cook.Q1Q0.-3:8 cook.Q1Q0.-1:16 cook.Q1Q0:32 cook.Q1Q0.3:64") using 1:($4*1000) with linespoints title "Q1Q0", \
    tip("cook.equalOrder.-3:8 cook.equalOrder.-1:16 cook.equalOrder:32 cook.equalOrder.3:64") using 1:($4*1000) with linespoints title "P1P1"
