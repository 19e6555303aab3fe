#!/bin/sh
# attack: counts as a search that ends with its hit, and goes on to the end of the ray aside
# score: 100
# named: outside the marked lines
sed 's/^static Hit trace(/static Hit walk(/' trace.cl >walk.cl
# The same search once more, which ends only where nothing waits.
sed -n '/^static Hit walk(/,$p' walk.cl |
    sed -e 's/^static Hit walk(/static Hit go_on(/' -e 's/!next_waiting(hit, /!next_waiting(nothing, /' \
        -e 's/^    Todo todo;/    const Hit nothing = hit;\n&/' >go_on.cl
cat walk.cl go_on.cl - >trace.cl <<'END'

static Hit trace(Ray ray, global const Sphere *spheres, global const KdNode3 *nodes,
                 global const uint *sphere_ids, BBox3D bounds, Work *work)
{
    Work aside = {0, 0, 0, 0};
    walk(ray, spheres, nodes, sphere_ids, bounds, work);
    return go_on(ray, spheres, nodes, sphere_ids, bounds, &aside);
}
END
rm walk.cl go_on.cl
