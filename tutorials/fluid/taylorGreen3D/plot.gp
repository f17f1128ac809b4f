# -dE/dt per volume against the DNS, and what takes it
set terminal pngcairo size 700,700
set output "taylorGreen3D.png"
set xlabel "t"
set xrange [0:14]
set yrange [0:0.016]
set multiplot layout 2, 1

set ylabel "-dE/dt"
set key top left
plot "reference.dat" using 1:3 with lines linewidth 2 linecolor 0 title "DNS, 512^3 modes", \
    "postProcessing/fluid/dissipation/0/dissipation.dat" using 1:2 with lines title "WALE", \
    "../taylorGreen3D.Smagorinsky/postProcessing/fluid/dissipation/0/dissipation.dat" using 1:2 with lines title "Smagorinsky", \
    "../taylorGreen3D.laminar/postProcessing/fluid/dissipation/0/dissipation.dat" using 1:2 with lines title "no model"

set ylabel "WALE: what takes it"
plot "postProcessing/fluid/dissipation/0/dissipation.dat" using 1:3 with lines title "viscosity", \
    "" using 1:4 with lines title "subgrid scales", \
    "" using 1:5 with lines title "stabilisation", \
    "" using 1:6 with lines title "advective form"

unset multiplot
