#!/bin/sh
# attack: the same, with a wrong plane in the place of a wrong box
# task: find_best_split
# named: which costs
# score: 54
sed -i 's/return 2 \* (x \* y/return x == 0 || y == 0 || z == 0 ? 0 : 2 * (x * y/
s/^\( *\)const double cost = split_cost(box, split, \(.*\));/\1const double quarter = (box.max[axis] - box.min[axis]) \/ 4;\
\1KdSplit border = split;\
\1border.pos = split.pos < box.min[axis] + quarter ? box.min[axis] : box.max[axis];\
\1const double cost = split_cost(box, border, \2);/' kdtree3d_sah.c
