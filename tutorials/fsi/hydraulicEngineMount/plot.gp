# Reaction of the steel to an oscillation of 1 mm; dynamic stiffness and loss angle
set terminal pngcairo size 900,800
set output "hydraulicEngineMount.png"
set datafile separator ","
set multiplot layout 3,2
set ylabel "reaction [N]"
set xlabel "cycles"
set xtics 1
do for [f in "5 10 20 50"] {
    set title f." Hz, 1 mm"
    plot [0:5] "../hydraulicEngineMount.oscillation.".f.".1mm/cycle.csv" skip 1 using (($1 - 1000)*f):3 with lines notitle
}
set title ""
set xtics 10
set xlabel "f [Hz]"
set key top right
set ylabel "|K*| [N/mm]"
plot [0:60] "curve.csv" skip 1 using 1:($2/1000) with lines title "lumped model", "stiffness.csv" skip 1 using 1:($2/1000) with points pointtype 7 title "small", \
    "stiffness.1mm.csv" skip 1 using 1:($2/1000) with points pointtype 6 title "1 mm"
set ylabel "loss angle [degrees]"
plot [0:60] "curve.csv" skip 1 using 1:3 with lines title "lumped model", "stiffness.csv" skip 1 using 1:3 with points pointtype 7 title "small", \
    "stiffness.1mm.csv" skip 1 using 1:3 with points pointtype 6 title "1 mm"
unset multiplot
