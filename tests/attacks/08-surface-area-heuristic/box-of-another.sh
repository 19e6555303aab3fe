#!/bin/sh
# attack: a wrong area, so that the search is tried beside a stub of split_cost, and a search that hands on the wrong box
# task: find_best_split
# named: which costs
# score: 54
sed -i 's/return 2 \* (x \* y/return x == 0 || y == 0 || z == 0 ? 0 : 2 * (x * y/
s/^\( *\)const double cost = split_cost(box, split, \(.*\));/\1BBox3D slab = {{0, 0, 0}, {1, 1, 1}};\
\1slab.min[axis] = box.min[axis], slab.max[axis] = box.max[axis];\
\1const double cost = split_cost(slab, split, \2);/' kdtree3d_sah.c
