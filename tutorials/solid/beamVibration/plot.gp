# Tips of the three beams
set terminal pngcairo size 700,300
set output "beamVibration.png"
set xlabel "t [s]"
set ylabel "Dy [mm]"
set xrange [0:3]
plot "< mfCompare -series tip1" using 1:(1e3*$3) with lines title "first mode", \
    "< mfCompare -series tip2" using 1:(1e3*$3) with lines title "second", \
    "< mfCompare -series tip3" using 1:(1e3*$3) with lines title "third"
