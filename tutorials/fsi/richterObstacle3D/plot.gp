# Deviation from the reference in per cent
set terminal pngcairo size 600,400
set output "richterObstacle3D.png"
set style fill solid 0.6
set boxwidth 0.13
set ylabel "deviation from the reference [%]"
set xzeroaxis linetype -1
set key outside top center horizontal
set xrange [-0.6:*]
set offsets 0, 0.6, 0, 0
set yrange [*:*]
case = "../richterObstacle3D"
plot \
    "< mfCompare -case . -data" using ($0 - 0.35):2 with boxes title "hex, order 2", \
    "< mfCompare -case ".case.".tets -data" using ($0 - 0.21):2 with boxes title "tets, order 2", \
    "< mfCompare -case ".case.".equalOrder -data" using ($0 - 0.07):2:xtic(1) with boxes title "hex, order 1", \
    "< mfCompare -case ".case.".equalOrder.fine -data" using ($0 + 0.07):2 with boxes title "finer", \
    "< mfCompare -case ".case.".equalOrderTets -data" using ($0 + 0.21):2 with boxes title "tets, order 1", \
    "< mfCompare -case ".case.".equalOrderTets.fine -data" using ($0 + 0.35):2 with boxes title "finer"
