# Cauchy stress of the modes over the stretch beside the closed forms
set terminal pngcairo size 600,400
set output "mooneyRivlinHomogeneous.png"
set xlabel "stretch (shear: amount + 1)"
set ylabel "Cauchy stress [MPa]"
set key top left
a = 0.3; b = 0.1
at(mode, column) = sprintf("< mfCompare -series %s", mode)
plot [1:2.05] \
    at("uniaxial", 2) using (1 + $1):($2/1e6) with points title "uniaxial", \
    2*(x*x - 1/x)*(a + b/x) with lines notitle linetype 1, \
    at("equibiaxial", 2) using (1 + $1):($2/1e6) with points title "equibiaxial", \
    2*(x*x - x**-4)*(a + b*x*x) with lines notitle linetype 2, \
    at("planar", 2) using (1 + $1):($2/1e6) with points title "planar", \
    2*(x*x - x**-2)*(a + b) with lines notitle linetype 3, \
    at("shear", 3) using (1 + $1):($3/1e6) with points title "shear", \
    2*(a + b)*(x - 1) with lines notitle linetype 4
