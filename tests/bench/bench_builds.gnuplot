# How long a tree takes to build, over the number of elements, from bench_builds.csv, as PNG and SVG:
# measured points, and the law of growth that was fitted to each builder's.
#
#     gnuplot -e "folder='build/bench'" tests/bench/bench_builds.gnuplot
csv = folder . '/bench_builds.csv'
set datafile separator ','
# A curve goes on across the rows of others.
set datafile missing NaN

only(builder, value) = strcol(1) eq builder ? value : NaN
share(ms, n) = ms * 1e6 / n

# Powers of ten around all times, and room for the key above the curves.
stats csv using 4 name 'SHORTEST' nooutput
stats csv using 5 name 'LONGEST' nooutput
stats csv using (share($4, $2)) name 'SMALLEST' nooutput
stats csv using (share($5, $2)) name 'LARGEST' nooutput
lowest(value) = 10.0 ** floor(log10(value))
highest(value) = 10.0 ** ceil(log10(value))

set logscale xy
set xrange [700:1.5e6]
set xtics ('2¹⁰' 2**10, '2¹²' 2**12, '2¹⁴' 2**14, '2¹⁶' 2**16, '2¹⁸' 2**18, '2²⁰' 2**20)
set grid xtics ytics linecolor rgb '#dddddd' linetype 1
set border 3
set tics nomirror scale 0.5
set xlabel 'N circles (lab 02) or spheres (the more, the smaller)'
# Filled where depth grows with the scene and the law is N log N; open where it is fixed and the law is N.
set style line 1 linecolor rgb '#c0392b' linewidth 2 pointtype 7 pointsize 1.4
set style line 2 linecolor rgb '#c0392b' linewidth 2 pointtype 6 pointsize 1.6 dashtype 2
set style line 3 linecolor rgb '#1f5fa8' linewidth 2 pointtype 5 pointsize 1.3
set style line 4 linecolor rgb '#1f5fa8' linewidth 2 pointtype 4 pointsize 1.5 dashtype 2
set style line 5 linecolor rgb '#3d8b40' linewidth 2 pointtype 9 pointsize 1.6

names = 'middle2d middle2d-fixed middle3d middle3d-fixed bycost3d'
titles = '"lab 02, 3 levels more than log₂ N" "lab 02, 8 levels" "lab 06, 6 levels more than log₂ N" "lab 06, 7 levels" "lab 08, by cost"'
law(i) = word(names, i)[strlen(word(names, i)) - 4 : *] eq 'fixed' ? 'N' : 'N log N'

do for [ending in 'png svg'] {
    if (ending eq 'png') {
        set terminal pngcairo size 1800,1500 font 'DejaVu Sans,18' background rgb 'white'
    } else {
        set terminal svg size 1350,1125 font 'DejaVu Sans,14' background rgb 'white'
    }
    set output folder . '/bench_builds.' . ending
    set multiplot layout 2,2
    set key top left reverse Left spacing 1.3
    set yrange [lowest(SHORTEST_min):highest(LONGEST_max) * 1000]
    set ytics ('0.01 ms' 0.01, '0.1 ms' 0.1, '1 ms' 1, '10 ms' 10, '100 ms' 100, '1 s' 1e3, '10 s' 1e4, '100 s' 1e5)
    set ylabel 'processor time'
    set title "Building a tree: median, smallest and largest time,\nand the law of growth that was fitted"
    plot for [i=1:5] csv using 2:(only(word(names, i), $6)) with lines linestyle i notitle, \
         for [i=1:5] csv using 2:(only(word(names, i), $3)):4:5 with yerrorbars linestyle i dashtype 1 notitle, \
         for [i=1:5] NaN with linespoints linestyle i title word(titles, i) . ': ' . law(i)
    unset key
    set yrange [lowest(SMALLEST_min):highest(LARGEST_max)]
    set ytics ('10 ns' 10, '100 ns' 100, '1 µs' 1e3, '10 µs' 1e4, '100 µs' 1e5)
    set ylabel 'processor time an element'
    set title "The same for each element: N log N rises, N is level\n"
    plot for [i=1:5] csv using 2:(only(word(names, i), share($6, $2))) with lines linestyle i, \
         for [i=1:5] csv using 2:(only(word(names, i), share($3, $2))):(share($4, $2)):(share($5, $2)) \
             with yerrorbars linestyle i dashtype 1
    set yrange [5:100]
    set ytics (5, 10, 20, 50, 100)
    set ylabel 'nodes an element'
    set title "Counted: how many nodes an element is handed on to\n"
    plot for [i=1:5] csv using 2:(only(word(names, i), $8 / $2)) with lines linestyle i, \
         for [i=1:5] csv using 2:(only(word(names, i), $7 / $2)) with points linestyle i
    set yrange [1:1e5]
    set ytics ('1' 1, '10' 10, '100' 100, '1000' 1e3, '10 000' 1e4, '100 000' 1e5)
    set ylabel 'elements a leaf'
    set title "The price of N: at a fixed depth the leaves grow\n"
    plot for [i=1:5] csv using 2:(only(word(names, i), $9)) with linespoints linestyle i
    unset multiplot
    set output
}
