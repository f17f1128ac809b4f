# Deviation from the reference in per cent
set terminal pngcairo size 600,400
set output "lidDrivenCavity.png"
set style fill solid 0.6
set boxwidth 0.38
set ylabel "deviation from the reference [%]"
set xzeroaxis linetype -1
set key off
set xrange [-0.6:*]
set offsets 0, 0.6, 0, 0
set yrange [*:*]
plot "< mfCompare -data" using 0:2:xtic(1) with boxes
