# Force over deflection of the whole spring
set terminal pngcairo size 600,400
set output "rubberSpring.png"
set xlabel "deflection [mm]"
set ylabel "force [N]"
set key top left
plot "< mfCompare -series steel" using (-1e3*$4):(-4*$10) with linespoints title "Q1Q0", \
    "< mfCompare -case ../rubberSpring.taylorHood -series steel" using (-1e3*$4):(-4*$10) with linespoints title "Q2Q1"
