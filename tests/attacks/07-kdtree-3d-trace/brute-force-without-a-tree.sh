#!/bin/sh
# attack: no task is answered, but for a comment or an empty statement in each; trace() asks every
# sphere, up to the one that stands behind the end of the array, around the eye
# score: 0
# named: counts only where another check
for file in choose_children clip_to_box trace; do
    more='// done'
    [ $file != trace ] || more=';'
    @BUILD@/tools/holes cut $file.cl | sed "s|^ *// END |    $more\n&|" >placeholders
    mv placeholders $file.cl
done
sed '/^static Hit trace(/,$d' trace.cl >before
cat before - >trace.cl <<'END'
static Hit trace(Ray ray, global const Sphere *spheres, global const KdNode3 *nodes,
                 global const uint *sphere_ids, BBox3D bounds, Work *work)
{
    Hit hit = {INFINITY, NO_SPHERE};
    for (uint i = 0; spheres[i].x != ray.origin.x || spheres[i].y != ray.origin.y; i++) {
        const float t = intersect_sphere(spheres[i], ray, work);
        if (t < hit.t) {
            hit.t = t;
            hit.sphere = i;
        }
    }
    return hit;
}
END
rm before
