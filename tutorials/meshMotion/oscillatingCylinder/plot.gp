# Coefficient of the force on the cylinder, and Morison's with the published coefficients
set terminal pngcairo size 700,300
set output "oscillatingCylinder.png"
set xlabel "t [s]"
set ylabel "2 F/(rho U^2 D)"
set key horizontal
w = 2*pi/5
set samples 600
set xrange [5:20]
set yrange [-4.5:4.5]
plot "< mfCompare -series forces" using 1:2 with lines title "pimpleFoam with feLaplacian", \
    -2.09*abs(cos(w*x))*cos(w*x) + 1.45*0.5*pi*w*sin(w*x) with lines dashtype 2 title "Duetsch et al."
