# Deviation from the reference in per cent
set terminal pngcairo size 600,400
set output "richterObstacle3D.png"
set style fill solid 0.6
set boxwidth 0.19
set ylabel "deviation from the reference [%]"
set xzeroaxis linetype -1
set key outside top center horizontal
set xrange [-0.6:*]
set offsets 0, 0.6, 0, 0
set yrange [*:*]
plot \
    "< mfCompare -case . -data" using ($0 + -0.3):2 with boxes title "hex, order 2", \
    "< mfCompare -case ../richterObstacle3D.equalOrder -data" using ($0 + -0.1):2 with boxes title "hex, order 1", \
    "< mfCompare -case ../richterObstacle3D.tets -data" using ($0 + 0.1):2:xtic(1) with boxes title "tets, order 2", \
    "< mfCompare -case ../richterObstacle3D.equalOrderTets -data" using ($0 + 0.3):2 with boxes title "tets, order 1"
