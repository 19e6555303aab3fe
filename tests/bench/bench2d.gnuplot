# Milliseconds a frame over the number of circles, from bench2d.csv, as PNG and SVG.
#
#     gnuplot -e "folder='build/bench'" tests/bench/bench2d.gnuplot
#
# The kd-tree's curve takes the rows of usual limits: those that the smallest scene was drawn with.
csv = folder . '/bench2d.csv'
set datafile separator ','

stats csv using (strcol(1) eq 'kdtree' && $2 == 64 ? $3 : NaN) name 'DEPTH' nooutput
stats csv using (strcol(1) eq 'kdtree' && $2 == 64 ? $4 : NaN) name 'LEAF' nooutput
stats csv using (strcol(1) eq 'fill' ? $5 : NaN) name 'FILL' nooutput
naive(value) = strcol(1) eq 'naive' ? value : NaN
kdtree(value) = strcol(1) eq 'kdtree' && $3 == DEPTH_min && $4 == LEAF_min ? value : NaN

set logscale xy
set xrange [45:46000]
set xtics (64, 512, 4096, 8192, 32768)
set format y '%g'
set ytics add ('1000000' 1e6)
set grid xtics ytics linecolor rgb '#dddddd' linetype 1
set border 3
set tics nomirror scale 0.5
set key top left reverse Left spacing 1.3
set xlabel 'circles (the more, the smaller: the same area in all)'
set ylabel 'milliseconds a frame'
set title "Naive and kd-tree, 1024x1024 pixels\nmedian, smallest and largest"
set style line 1 linecolor rgb '#c0392b' linewidth 2.5 pointtype 7 pointsize 1.1
set style line 2 linecolor rgb '#1f5fa8' linewidth 2.5 pointtype 5 pointsize 1.0
set style line 3 linecolor rgb '#666666' linewidth 1.5 dashtype 2

do for [ending in 'png svg'] {
    if (ending eq 'png') {
        set terminal pngcairo size 1200,800 font 'DejaVu Sans,18' background rgb 'white'
    } else {
        set terminal svg size 900,600 font 'DejaVu Sans,14' background rgb 'white'
    }
    set output folder . '/bench2d.' . ending
    plot csv using 2:(naive($5)):6:7 with yerrorlines linestyle 1 title 'naive (lab 01)', \
         csv using 2:(kdtree($5)):6:7 with yerrorlines linestyle 2 title 'kd-tree (lab 03)', \
         FILL_min with lines linestyle 3 title 'only writing the pixels'
    set output
}
