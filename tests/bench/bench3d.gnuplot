# Time a frame, and time to build the trees, over the number of random spheres, from bench3d.csv, as
# PNG and SVG.
#
#     gnuplot -e "folder='build/bench'" tests/bench/bench3d.gnuplot
csv = folder . '/bench3d.csv'
set datafile separator ','
# A curve goes on across the rows of others.
set datafile missing NaN

is_random(renderer) = strcol(1) eq renderer && strcol(2)[1:6] eq 'random'
only(renderer, value) = is_random(renderer) ? value : NaN

# Embree takes part where it is installed: with the quickest of its calls.
is_embree(row) = strcol(1)[1:6] eq 'embree' && strcol(2)[1:6] eq 'random' && strcol(21) eq '1'
stats csv using (is_embree(0) ? 1 : 0) name 'EMBREE' nooutput
has_embree = EMBREE_sum > 0
embree_title = has_embree ? 'Embree' : ''
best_title = has_embree ? 'Embree, its best call' : ''
embree(value) = is_embree(0) ? value : NaN
stats csv using (only('naive', $8)) name 'SHARE' nooutput
note = SHARE_min < 1 ? "\nlarge scenes, naive: a part of the picture, scaled" : "\n"

# Whole powers of ten, and room for the key above the curves.
stats csv using 5 name 'FRAME' nooutput
stats csv using 6 name 'LONGEST_FRAME' nooutput
stats csv using (strcol(1) ne 'naive' ? $10 : NaN) name 'BUILD' nooutput
stats csv using (strcol(1) ne 'naive' ? $11 : NaN) name 'LONGEST_BUILD' nooutput
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

do for [ending in 'png svg'] {
    if (ending eq 'png') {
        set terminal pngcairo size 1800,800 font 'DejaVu Sans,18' background rgb 'white'
    } else {
        set terminal svg size 1350,600 font 'DejaVu Sans,14' background rgb 'white'
    }
    set output folder . '/bench3d.' . ending
    set multiplot layout 1,2
    set ylabel 'time a frame'
    set yrange [lowest(FRAME_min):highest(LONGEST_FRAME_max)]
    set title "A frame of 1024x1024 rays: median, smallest and largest" . note
    plot csv using 3:(only('naive', $4)):5:6 with yerrorlines linestyle 1 title 'naive (lab 05)', \
         csv using 3:(only('kdtree', $4)):5:6 with yerrorlines linestyle 2 \
             title 'kd-tree (lab 07)', \
         csv using 3:(only('tiles', $4)):5:6 with yerrorlines linestyle 4 title 'tiles (lab 10)', \
         csv using 3:(embree($4)):5:6 with yerrorlines linestyle 3 title best_title
    set ylabel 'time to build'
    set yrange [lowest(BUILD_min):highest(LONGEST_BUILD_max)]
    set title "The trees, built on one thread: median, smallest and largest\n"
    plot csv using 3:(only('kdtree', $9)):10:11 with yerrorlines linestyle 2 \
             title 'kd-tree (lab 06)', \
         csv using 3:(only('tiles', $9)):10:11 with yerrorlines linestyle 4 \
             title 'by cost, for the tiles (lab 08)', \
         csv using 3:(embree($9)):10:11 with yerrorlines linestyle 3 title embree_title
    unset multiplot
    set output
}
