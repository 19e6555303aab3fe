#!/bin/sh
# attack: lets our solution of another task do its work, where that should stand beside it
# score: 0
# named: found
cp "@COURSE@/labs/05-spheres/intersect_sphere.cl" skeleton.cl
cat >answer.cl <<'END'
    float intersect_sphere(Sphere sphere, Ray ray, Work *work);
    Work aside = {0, 0, 0, 0};
    return intersect_sphere(sphere, ray, &aside);
END
@BUILD@/tools/holes fill skeleton.cl intersect_textbook answer.cl >intersect_sphere.cl
cp "@COURSE@/labs/05-spheres/nearest_hit.cl" "@COURSE@/labs/05-spheres/shade.cl" .
