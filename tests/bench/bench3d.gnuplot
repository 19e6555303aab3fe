# Time a frame and time to build the trees, over the number of random spheres, for scenes that stand still
# and for scenes that move. Started by tables.sh.
load 'tests/bench/style.gnuplot'
set terminal svg size 1950,750 font 'DejaVu Sans,14' background rgb 'white'
set output folder . '/bench3d.svg'

random(what, quantity, ms) = of_spheres(seconds(what, quantity, ms))

set xrange [0.7:1.5e6]
set xtics ('1' 1, '10' 10, '100' 100, '1000' 1e3, '10⁴' 1e4, '10⁵' 1e5, '10⁶' 1e6)
set xlabel 'random spheres (the more, the smaller)'
names = '"naive" "kd-tree" "kd-tree by cost" "tiles" "Embree, best call"'
titles = '"naive (lab 05)" "tree of lab 06, kernel of lab 07" "tree of lab 08, kernel of lab 07" "tree of lab 08, tiles of lab 10" Embree'
curve(i, quantity, ms) = random(word(names, i), quantity, ms)
# The last curve: Embree takes part where it is installed.
last = system('grep -c Embree ' . csv) > 0 ? 5 : 4

set multiplot layout 1,3
set ylabel 'time a frame'
set title "A frame of 1024x1024 rays: median, smallest and largest;\nnaive, large scenes, on a CPU: a part of the picture, scaled"
plot for [i=1:last] csv using 2:(curve(i, 'frame', $5)):($6 / 1e3):($7 / 1e3) \
         with yerrorlines linestyle i title word(titles, i)
do for [frames in '15 60'] {
    set label '1/' . frames . ' s' at first 1.4e6, first 1.0 / frames right offset 0, 0.5
}
set title "The same in a scene that moves: the tree is built anew\nfor each frame, on one thread"
plot for [i=1:4] csv using 2:(curve(i, 'moving frame', $5)):($6 / 1e3):($7 / 1e3) \
         with yerrorlines linestyle i title word(titles, i), \
     1.0 / 60 linestyle 8 notitle, 1.0 / 15 linestyle 8 notitle
set ylabel 'time to build'
set title "The trees alone, built on one thread\n"
names = 'naive "kd-tree" "kd-tree by cost" "tiles" Embree'
plot for [i=2:last] csv using 2:(curve(i, 'build', $5)):($6 / 1e3):($7 / 1e3) \
         with yerrorlines linestyle i title word(titles, i), \
     1.0 / 60 linestyle 8 notitle, 1.0 / 15 linestyle 8 notitle
unset multiplot
