# Time a frame of a moving scene, over the number of random spheres, from bench3d-moving.csv, as PNG
# and SVG.
#
#     gnuplot -e "folder='build/bench'" tests/bench/bench3d-moving.gnuplot
csv = folder . '/bench3d-moving.csv'
set datafile separator ','
# A curve goes on across the rows of others.
set datafile missing NaN

only(renderer, value) = strcol(1) eq renderer ? value : NaN

# Whole powers of ten, and room for the key above the curves.
stats csv using 3 name 'BUILD' nooutput
stats csv using 7 name 'SHORTEST' nooutput
stats csv using 8 name 'WHOLE' nooutput
lowest(ms) = 10.0 ** floor(log10(ms)) * 0.999
highest(ms) = 10.0 ** ceil(log10(ms)) * 10

set logscale xy
set xrange [0.7:1.5e6]
set xtics ('1' 1, '10' 10, '100' 100, '1000' 1e3, '10⁴' 1e4, '10⁵' 1e5, '10⁶' 1e6)
set ytics ('0.001 ms' 1e-3, '0.01 ms' 1e-2, '0.1 ms' 0.1, '1 ms' 1, '10 ms' 10, '100 ms' 100, \
           '1 s' 1e3, '10 s' 1e4, '100 s' 1e5, '1000 s' 1e6, '10 000 s' 1e7, \
           '100 000 s' 1e8)
set grid xtics ytics linecolor rgb '#dddddd' linetype 1
set border 3
set tics nomirror scale 0.5
set key top left reverse Left spacing 1.3
set xlabel 'random spheres (the more, the smaller)'
set style line 1 linecolor rgb '#c0392b' linewidth 2.5 pointtype 7 pointsize 1.1
set style line 2 linecolor rgb '#1f5fa8' linewidth 2.5 pointtype 5 pointsize 1.0
set style line 3 linecolor rgb '#3d8b40' linewidth 2.5 pointtype 9 pointsize 1.2
set style line 4 linecolor rgb '#8e44ad' linewidth 2.5 pointtype 13 pointsize 1.2
set style line 5 linecolor rgb '#000000' linewidth 1.5 dashtype 2
do for [frames in '15 60'] {
    set label '1/' . frames . ' s' at first 1.4e6, first 1e3 / frames right offset 0, 0.5
}

do for [ending in 'png svg'] {
    if (ending eq 'png') {
        set terminal pngcairo size 1800,800 font 'DejaVu Sans,18' background rgb 'white'
    } else {
        set terminal svg size 1350,600 font 'DejaVu Sans,14' background rgb 'white'
    }
    set output folder . '/bench3d-moving.' . ending
    set multiplot layout 1,2
    set ylabel 'time a frame'
    set yrange [lowest(SHORTEST_min):highest(WHOLE_max)]
    set title "Building the tree and drawing 1024x1024 pixels: median, smallest\nand largest of the rounds"
    plot csv using 2:(only('naive', $6)):7:8 with yerrorlines linestyle 1 \
             title 'naive (lab 05), without a tree', \
         csv using 2:(only('kdtree', $6)):7:8 with yerrorlines linestyle 2 \
             title 'tree of lab 06, kernel of lab 07', \
         csv using 2:(only('bycost', $6)):7:8 with yerrorlines linestyle 3 \
             title 'tree of lab 08, kernel of lab 07', \
         csv using 2:(only('tiles', $6)):7:8 with yerrorlines linestyle 4 \
             title 'tree of lab 08, tiles of lab 10', \
         1e3 / 60 linestyle 5 notitle, 1e3 / 15 linestyle 5 notitle
    set ylabel 'time to build'
    set yrange [lowest(BUILD_min):highest(BUILD_max)]
    set title "Building the tree alone, on one thread: medians\n"
    plot csv using 2:(only('kdtree', $3)) with linespoints linestyle 2 title 'lab 06', \
         csv using 2:(only('bycost', $3)) with linespoints linestyle 3 title 'lab 08', \
         csv using 2:(only('tiles', $3)) with linespoints linestyle 4 \
             title 'lab 08, larger leaves for the tiles', \
         1e3 / 60 linestyle 5 notitle, 1e3 / 15 linestyle 5 notitle
    unset multiplot
    set output
}
