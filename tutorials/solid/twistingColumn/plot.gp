# Energies of the clamped column and moments of momentum of both
set terminal pngcairo size 700,500
set output "twistingColumn.png"
set xlabel "t [s]"
set key right
set multiplot layout 2, 1

set ylabel "energy [MJ]"
plot "< mfCompare -series energyOfClamped" using 1:(1e-6*$2) with lines title "kinetic", \
    "" using 1:(1e-6*$3) with lines title "strain", \
    "" using 1:(1e-6*($2 + $3)) with lines linecolor 0 title "sum"

set ylabel "moment about y [kN m s]"
plot "< mfCompare -series energyOfClamped" using 1:(1e-3*$13) with lines title "clamped", \
    "< mfCompare -series energy" using 1:(1e-3*$13) with lines linecolor 0 title "free"

unset multiplot
