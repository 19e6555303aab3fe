#!/bin/sh
# attack: the same, and a ray_color that sends the right rays and hands on another material than the sphere's
# task: ray_color
# named: pixels differ
# score: 77
sed -i 's/^\( *\)ray.direction = way \/ ray.t_max;/&\
\1ray.t_min = 1e-20f;/' shadows.cl
sed -i 's/^\( *\)color += weight \* lit_color(at.point, at.normal, at.material, scene, work);/\1Material plain = at.material;\
\1plain.kd = 1.0f;\
\1color += weight * lit_color(at.point, at.normal, plain, scene, work);/' mirrors.cl
