#!/bin/sh
# attack: the same, by the name that the assembler sees
# score: 0
# named: asm
cp "@COURSE@/labs/05-spheres/intersect_sphere.cl" skeleton.cl
cat >answer.cl <<'END'
    float other(Sphere sphere, Ray ray, Work *work) __asm__("intersect_sphere");
    Work aside = {0, 0, 0, 0};
    return other(sphere, ray, &aside);
END
@BUILD@/tools/holes fill skeleton.cl intersect_textbook answer.cl >intersect_sphere.cl
cp "@COURSE@/labs/05-spheres/nearest_hit.cl" "@COURSE@/labs/05-spheres/shade.cl" .
