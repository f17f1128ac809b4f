# Reaction of the steel to an oscillation of 1 mm; dynamic stiffness and loss angle at 0.1 mm
set terminal pngcairo size 900,900
set output "hydraulicEngineMount.png"
set datafile separator ","
set multiplot layout 4,2
set ylabel "reaction [N]"
set xlabel "cycles"
do for [f in "5 10 20 50"] {
    set title f." Hz"
    plot "../hydraulicEngineMount.oscillation.".f.".1mm/cycle.csv" skip 1 using (($1 - 1000)*f):3 with lines notitle
}
set title ""
set xlabel "f [Hz]"
set key top left
set ylabel "|K*| [N/mm]"
plot "stiffness.csv" skip 1 using 1:($4/1000) with linespoints title "lumped model", "" skip 1 using 1:($2/1000) with points pointtype 7 title "computed, 0.1 mm", \
    "stiffness.1mm.csv" skip 1 using 1:($2/1000) with points pointtype 6 title "1 mm"
set ylabel "loss angle [degrees]"
plot "stiffness.csv" skip 1 using 1:5 with linespoints title "lumped model", "" skip 1 using 1:3 with points pointtype 7 title "computed, 0.1 mm", \
    "stiffness.1mm.csv" skip 1 using 1:3 with points pointtype 6 title "1 mm"
unset multiplot
