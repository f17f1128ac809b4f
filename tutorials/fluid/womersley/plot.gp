# The flow over time against Womersley's
set terminal pngcairo size 600,400
set output "womersley.png"
set xlabel "t [s]"
set ylabel "u on the axis [m/s]"
set key bottom right
I = {0, 1}
J0(a, s) = 1 + I*a*s/4*(1 + I*a*s/16*(1 + I*a*s/36*(1 + I*a*s/64*(1 + I*a*s/100*(1 + I*a*s/144*(1 + I*a*s/196*(1 + I*a*s/256*(1 + I*a*s/324*(1 + I*a*s/400)))))))))
a = 8*pi
u(t) = real(100/(2000*pi*I)*(1 - 1/J0(a, 1))*exp(2*pi*I*t))
plot "postProcessing/fluid/axis/0/pointHistory.dat" using 1:4 with points title "computed", \
    u(x) with lines title "exact"
