// A scene that only a search through the tree draws right.
//
// Counts are written by the code that is judged, so they can be forged. What a sphere does to a
// picture cannot: here some leaves also list a sphere that does not lie in them, the one behind the
// end of the array, which is around the eye (job_scene3d.h). A ray that meets none of these leaves
// is never asked about it; an answer that asks all spheres, or goes on behind the hit, finds it,
// whatever it counts.
#include "judge_07.h"

#include "complain.h"
#include "job_scene3d_tree.h"
#include "judge_07_work.h"

#include <math.h>
#include <stdlib.h>

// Let about one leaf of `every` list one sphere more. The ids of all are packed anew. Returns 0, or
// -1 after one message.
static int list_decoy(Random *random, KdTree3D *tree, u32 decoy, int every)
{
    u32 *ids = malloc(((size_t)tree->n_sphere_ids + tree->n_nodes) * sizeof *ids);
    u32 n = 0;
    if (ids == NULL) {
        complain("grade: no memory for a scene");
        return -1;
    }
    for (u32 id = 0; id < tree->n_nodes; id++) {
        KdNode3 *node = &tree->nodes[id];
        if (node->split_axis != KD_LEAF) {
            continue;
        }
        const u32 first = n;
        for (u32 i = 0; i < node->n_spheres; i++) {
            ids[n++] = tree->sphere_ids[node->first + i];
        }
        if (random_integer(random, 1, every) == 1) {
            ids[n++] = decoy;
        }
        node->first = first;
        node->n_spheres = n - first;
    }
    free(tree->sphere_ids);
    tree->sphere_ids = ids;
    tree->n_sphere_ids = n;
    return 0;
}

int roll_decoys_07(Random *random, JobScene3D *scene)
{
    enum { N_SPHERES = 200, EVERY = 5 };
    if (job_scene3d_random(scene, random, N_SPHERES, 0.0625f, 0.1875f, 64, 48) != 0 ||
        job_scene3d_grow_tree(scene, (KdTreeLimits){12, 4}) != 0) {
        return -1;
    }
    snprintf(scene->picture.title, sizeof scene->picture.title, "scene \"decoys\", 64x48");
    return list_decoy(random, &scene->tree, N_SPHERES, EVERY);
}

void decoys_07_expect(JobScene3D *scene)
{
    const Scene3D *s = &scene->scene;
    for (int pixel = 0; pixel < s->width * s->height; pixel++) {
        const OracleRay ray = job_scene3d_ray(scene, pixel);
        if (search3d_may_ask(scene, &ray, (u32)s->n_spheres)) {
            scene->hits[pixel].is_ambiguous = 1;
            scene->picture.expected.tolerances[pixel] = INFINITY;
        }
    }
}
