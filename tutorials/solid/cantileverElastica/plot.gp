# Path of the tips over the load
set terminal pngcairo size 600,400
set output "cantileverElastica.png"
set xlabel "load P L^2/EI, q L^3/EI"
set ylabel "tip deflection/L, shortening/L"
set key top left
set yrange [0:1.35]
at(case) = sprintf("< mfCompare -series %s", case)
plot at("end10") using (10*$1):3 with lines title "deflection, end load", \
    at("end10") using (10*$1):(-$2) with lines title "shortening, end load", \
    at("uniform8") using (8*$1):3 with lines title "deflection, uniform load", \
    at("uniform8") using (8*$1):(-$2) with lines title "shortening, uniform load", \
    "< echo 1 0.30172 0.05643; echo 2 0.49346 0.16064; echo 3 0.60325 0.25442; echo 4 0.66996 0.32894; echo 6 0.74457 0.43459; echo 8 0.78498 0.50483; echo 10 0.81061 0.555" using 1:2 with points pointtype 7 title "elastica", \
    "" using 1:3 with points pointtype 7 notitle, \
    "< echo 1 0.12347 0.00875; echo 2 0.23851 0.03311; echo 4 0.42516 0.10989; echo 8 0.64063 0.27558" using 1:2 with points pointtype 7 notitle, \
    "" using 1:3 with points pointtype 7 notitle
