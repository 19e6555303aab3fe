# What the plots of the bench share: the columns of medians.tsv (tables.sql), axes and lines.
csv = folder . '/medians.tsv'
set datafile separator tab
set datafile columnheaders
# A curve goes on across the rows of others.
set datafile missing NaN

# A value of a row, if the row is of that curve.
only(what, quantity, value) = strcol(3) eq what && strcol(4) eq quantity ? value : NaN
# Times are in milliseconds.
seconds(what, quantity, ms) = only(what, quantity, ms / 1e3)
of_circles(seconds) = strstrt(strcol(1), 'circles') > 0 ? seconds : NaN
of_spheres(seconds) = strcol(1)[1:9] eq 'random:n=' ? seconds : NaN

set logscale xy
set format y '%.0s %cs'
set grid xtics ytics linecolor rgb '#dddddd' linetype 1
set border 3
set tics nomirror scale 0.5
set key below left reverse Left spacing 1.3
set style line 1 linecolor rgb '#c0392b' linewidth 2 pointtype 7 pointsize 1.1
set style line 2 linecolor rgb '#1f5fa8' linewidth 2 pointtype 5 pointsize 1.0
set style line 3 linecolor rgb '#3d8b40' linewidth 2 pointtype 9 pointsize 1.2
set style line 4 linecolor rgb '#8e44ad' linewidth 2 pointtype 13 pointsize 1.2
set style line 5 linecolor rgb '#666666' linewidth 2 pointtype 11 pointsize 1.2
# As 1 and 2, open; and a limit.
set style line 6 linecolor rgb '#c0392b' linewidth 2 pointtype 6 pointsize 1.4 dashtype 2
set style line 7 linecolor rgb '#1f5fa8' linewidth 2 pointtype 4 pointsize 1.3 dashtype 2
set style line 8 linecolor rgb '#000000' linewidth 1.5 dashtype 2
