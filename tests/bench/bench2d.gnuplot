# Time a frame over the number of circles. Started by tables.sh.
load 'tests/bench/style.gnuplot'
set terminal svg size 900,650 font 'DejaVu Sans,14' background rgb 'white'
set output folder . '/bench2d.svg'

# Two scenes have the lecture's number of circles and other radii: they are of no curve.
is_growing(scene) = scene ne '8192 circles, radius 1 to 4' && scene ne '8192 circles, radius 10 to 60'
frame(what, ms) = is_growing(strcol(1)) ? of_circles(seconds(what, 'frame', ms)) : NaN

set xtics (64, 512, 4096, 8192, 32768)
set xlabel 'circles (the more, the smaller: the same area in all)'
set ylabel 'time a frame'
set title "Naive and kd-tree, 1024x1024 pixels\nmedian, smallest and largest"
plot csv using 2:(frame('naive', $5)):($6/1e3):($7/1e3) with yerrorlines linestyle 1 title 'naive (lab 01)', \
     csv using 2:(frame('kd-tree', $5)):($6/1e3):($7/1e3) with yerrorlines linestyle 2 title 'kd-tree (lab 03)'
