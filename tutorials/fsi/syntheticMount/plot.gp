# Dynamic stiffness and loss angle
set terminal pngcairo size 700,500
set output "syntheticMount.png"
set datafile separator ","
set multiplot layout 2,1
set key top right
set ylabel "|K*| [N/mm]"
plot "stiffness.csv" skip 1 using 1:($4/1000) with lines title "closed form", "" skip 1 using 1:($2/1000) with points pointtype 7 pointsize 0.5 title "computed"
set xlabel "f [Hz]"
set ylabel "loss angle [degrees]"
plot "stiffness.csv" skip 1 using 1:5 with lines title "closed form", "" skip 1 using 1:3 with points pointtype 7 pointsize 0.5 title "computed"
unset multiplot
