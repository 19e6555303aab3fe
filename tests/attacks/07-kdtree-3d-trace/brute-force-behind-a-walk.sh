#!/bin/sh
# attack: walks the tree as it should, for the counts, and then asks every sphere of every leaf aside
# score: 100
# named: outside the marked lines
sed 's/^static Hit trace(/static Hit walk(/' trace.cl >walk.cl
cat walk.cl - >trace.cl <<'END'

static Hit trace(Ray ray, global const Sphere *spheres, global const KdNode3 *nodes,
                 global const uint *sphere_ids, BBox3D bounds, Work *work)
{
    walk(ray, spheres, nodes, sphere_ids, bounds, work);
    Hit hit = {INFINITY, NO_SPHERE};
    Work aside = {0, 0, 0, 0};
    uint last = 0;
    for (uint id = 0; id <= last; id++) {
        if (nodes[id].split_axis != KD_LEAF) {
            last = nodes[id].first + 1;
        } else {
            search_leaf(nodes[id], sphere_ids, spheres, ray, &hit, &aside);
        }
    }
    return hit;
}
END
rm walk.cl
