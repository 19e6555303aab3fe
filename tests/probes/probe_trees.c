// The trees of a job's scenes, for the probes of labs 06 and 08 (probe_answer_trees() of probe.h).
#include "probe.h"

static void answer_tree(const Probe *probe, int k, const TreeJob3D *job, BuildTree3D *build)
{
    size_t n_bytes;
    const Sphere *spheres = probe_scene_part(probe, k, "spheres", &n_bytes);
    const KdTreeLimits limits = {job->maxDepth, job->targetElementsPerNode};
    KdTree3D tree = {0};
    probe_note(probe, "tree", (uint32_t)k);
    if (build(spheres, job->n_spheres, limits, &tree) != 0) {
        probe_answer(probe, "tree", k, "refused", "", 0);
        return;
    }
    const TreeAnswer3D answer = {tree.bounds, tree.n_nodes, tree.n_sphere_ids};
    probe_answer(probe, "tree", k, NULL, &answer, sizeof answer);
    if (tree.n_nodes <= TREE3D_ANSWER_NODES && tree.n_sphere_ids <= TREE3D_ANSWER_IDS) {
        probe_answer(probe, "tree", k, "nodes", tree.nodes, tree.n_nodes * sizeof *tree.nodes);
        probe_answer(probe, "tree", k, "ids", tree.sphere_ids,
                     tree.n_sphere_ids * sizeof *tree.sphere_ids);
    }
    tree3d_free(&tree);
}

// Scene number k, or NULL when the job has no more.
static const TreeJob3D *tree_job(const Probe *probe, int k)
{
    char name[SECTION_NAME_BYTES];
    snprintf(name, sizeof name, "scene.%d", k);
    return sections_find(&probe->job, name, sizeof(TreeJob3D));
}

void probe_answer_trees(const Probe *probe, BuildTree3D *build)
{
    const TreeJob3D *job;
    for (int k = 0; (job = tree_job(probe, k)) != NULL; k++) {
        answer_tree(probe, k, job, build);
    }
}
