#!/bin/sh
# attack: answers rays from a table of what each pixel hit with seed 1, as in reports that were handed back
# task: nearest_hit
# seed: 2
# named: nearest_hit
{
    sed '/^Hit nearest_hit/,$d' nearest_hit.cl
    "@BUILD@/tools/learned" 05 1
    sed -n '/^Hit nearest_hit/,/\/\/ TASK nearest_hit/p' nearest_hit.cl
    cat <<'C'
    const int seen = learned_id(n_spheres, 0, 0, 0, get_global_id(0), get_global_id(1));
    if (seen >= 0 && seen < n_spheres) {
        hit.t = intersect_sphere(spheres[seen], ray, work);
        hit.sphere = seen;
    }
C
    sed -n '/\/\/ END nearest_hit/,$p' nearest_hit.cl
} >new.cl
mv new.cl nearest_hit.cl
