#!/bin/sh
# attack: the same, by a name that no text has: put together by the preprocessor
# score: 0
# named: found
cp "@COURSE@/labs/05-spheres/intersect_sphere.cl" skeleton.cl
cat >answer.cl <<'END'
#define P(a, b) a##b
    float P(intersect_, sphere)(Sphere sphere, Ray ray, Work *work);
    Work aside = {0, 0, 0, 0};
    return P(intersect_, sphere)(sphere, ray, &aside);
END
@BUILD@/tools/holes fill skeleton.cl intersect_textbook answer.cl >intersect_sphere.cl
cp "@COURSE@/labs/05-spheres/nearest_hit.cl" "@COURSE@/labs/05-spheres/shade.cl" .
