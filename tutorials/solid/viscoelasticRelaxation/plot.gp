# Forces over time beside the closed form of the relaxation
set terminal pngcairo size 600,400
set output "viscoelasticRelaxation.png"
set xlabel "time [s]"
set ylabel "force [N]"
set key top left
Q(g, tau, t) = g*tau/1e-3*(exp(1e-3/tau) - 1)*exp(-t/tau)
G(t) = 1 + Q(0.5, 0.01, t) + Q(0.2, 0.1, t)
plot [0.5:1] \
    "< mfCompare -series oscillation" using 1:2 with lines title "oscillation", \
    "< mfCompare -series relaxation" using 1:2 with points pointinterval 5 title "relaxation", \
    (x > 0.901 ? 240*G(x - 0.9) : 1/0) with lines title "closed form"
