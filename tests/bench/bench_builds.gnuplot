# How long a tree takes to build, over the number of elements: measured points, and the law of growth that was
# fitted to each builder's. Started by tables.sh.
load 'tests/bench/style.gnuplot'
set terminal svg size 1350,1300 font 'DejaVu Sans,14' background rgb 'white'
set output folder . '/bench_builds.svg'

names = '"lab 02, 3 levels more than log2 N" "lab 06, 6 levels more than log2 N" "lab 08, by cost" "lab 02, 8 levels" "lab 06, 7 levels"'
name(i) = word(names, i)
# Filled where depth grows with the scene and the law is N log N; open where it is fixed and the law is N.
style(i) = i < 4 ? i : i + 2
law(i) = i < 4 ? 'N log N' : 'N'

set xrange [700:1.5e6]
set xtics ('2¹⁰' 2**10, '2¹²' 2**12, '2¹⁴' 2**14, '2¹⁶' 2**16, '2¹⁸' 2**18, '2²⁰' 2**20)
set xlabel 'N circles (lab 02) or spheres (the more, the smaller)'
set multiplot layout 2,2
set ylabel 'processor time'
set title "Building a tree: median, smallest and largest time,\nand the law of growth that was fitted"
plot for [i=1:5] csv using 2:(seconds(name(i), 'build, ' . law(i), $5)) with lines linestyle style(i) notitle, \
     for [i=1:5] csv using 2:(seconds(name(i), 'build', $5)):($6 / 1e3):($7 / 1e3) \
         with yerrorbars linestyle style(i) dashtype 1 title name(i) . ': ' . law(i)
set ylabel 'processor time an element'
set title "The same for each element: N log N rises, N is level\n"
plot for [i=1:5] csv using 2:(seconds(name(i), 'build, ' . law(i), $5) / $2) with lines linestyle style(i) notitle, \
     for [i=1:5] csv using 2:(seconds(name(i), 'build', $5) / $2):($6 / 1e3 / $2):($7 / 1e3 / $2) \
         with yerrorbars linestyle style(i) dashtype 1 notitle
set format y '%g'
set ylabel 'nodes an element'
set title "Counted: how many nodes an element is handed on to\n"
plot for [i=1:5] csv using 2:(only(name(i), 'handed on, ' . law(i), $5 / $2)) with lines linestyle style(i) notitle, \
     for [i=1:5] csv using 2:(only(name(i), 'handed on', $5 / $2)) with points linestyle style(i) notitle
set ylabel 'elements a leaf'
set title "The price of N: at a fixed depth the leaves grow\n"
plot for [i=1:5] csv using 2:(only(name(i), 'per leaf', $5)) with linespoints linestyle style(i) notitle
unset multiplot
