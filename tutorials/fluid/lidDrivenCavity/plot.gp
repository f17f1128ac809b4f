# Deviation from the reference in per cent
set terminal pngcairo size 600,400
set output "lidDrivenCavity.png"
set style fill solid 0.6
set boxwidth 0.38
set ylabel "deviation from the reference [%]"
set xzeroaxis linetype -1
set key outside top center horizontal
set xrange [-0.6:*]
set offsets 0, 0.6, 0, 0
set yrange [*:*]
plot \
    "< mfCompare -case . -data" using ($0 + -0.2):2 with boxes title "Re 100", \
    "< mfCompare -case ../lidDrivenCavity.Re1000 -data" using ($0 + 0.2):2:xtic(1) with boxes title "Re 1000"
