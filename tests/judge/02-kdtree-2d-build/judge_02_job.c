// Rolling lab 02's scenes, and with them the job, from the seed: see judge_02.h.
#include "judge_02.h"

#include "oracle2d_tree.h"

// Let some circles of a scene lie one upon another in its middle: no split parts them.
static void pile_up(Scene2D *scene)
{
    for (int i = 20; i < 32; i++) {
        scene->circles[i].x = (float)(scene->width / 2);
        scene->circles[i].y = (float)(scene->height / 2);
        scene->circles[i].radius = 16;
    }
}

// How many leaves of the scene's tree are empty? Returns -1 after one message.
static int count_empty_leaves(const Scene2D *scene, KdTreeLimits limits)
{
    Growth growth = {0};
    KdTree2D tree = {0};
    int n = oracle2d_tree(scene, 0, limits, &growth, &tree);
    for (u32 id = 0; n >= 0 && id < tree.n_nodes; id++) {
        n += tree.nodes_flag[id] == LEAF &&
             tree.mapNode2Circles[tree.nodes_Relations[id].circleMapOffset] == 0;
    }
    tree2d_free(&tree);
    growth_free(&growth);
    return n;
}

// A scene whose tree has two empty leaves, each with a list of its own. It has fewer in some of its
// sizes.
static int roll_with_gaps(Random *random, JobScene *scene, KdTreeLimits limits)
{
    int n_empty = 0;
    do {
        job_scene_free(scene);
        if (job_scene_named(scene, random, "tiny", 64, 48) != 0) {
            return -1;
        }
        n_empty = count_empty_leaves(&scene->scene, limits);
    } while (n_empty == 0 || n_empty == 1);
    return n_empty < 0 ? -1 : 0;
}

static int roll_scenes(Random *random, JobScene scenes[N_SCENES], Growth *growth)
{
    static const KdTreeLimits limits[N_SCENES] = {{7, 4}, {4, 1}, {16, 6}, {6, 2},
                                                  {9, 1}, {4, 1}, {1, 3},  {2, 3}};
    int result = job_scene_random(&scenes[0], random, 150, 14, 200, 150);
    result |= job_scene_named(&scenes[1], random, "example", 10, 10);
    result |= job_scene_random(&scenes[2], random, 300, 10, 120, 240);
    result |= job_scene_named(&scenes[3], random, "touching", 64, 48);
    result |= roll_with_gaps(random, &scenes[4], limits[4]);
    result |= job_scene_named(&scenes[5], random, "none", 64, 48);
    result |= job_scene_random(&scenes[DISTRIBUTE_SCENE], random, DISTRIBUTE_MAX_IDS, 10, 200, 150);
    result |= job_scene_pile(&scenes[PILE], random);
    if (result == 0) {
        Circle *circles = scenes[DISTRIBUTE_SCENE].scene.circles;
        // Circles that are equal are two all the same.
        circles[1] = circles[0];
        circles[DISTRIBUTE_MAX_IDS - 1] = circles[2];
        pile_up(&scenes[2].scene);
    }
    for (int k = 0; result == 0 && k < N_SCENES; k++) {
        scenes[k].limits = limits[k];
        result = oracle2d_tree(&scenes[k].scene, (u32)k, limits[k], growth, &scenes[k].tree);
    }
    return result;
}

int roll_job_02(void *pointer, Random *random)
{
    Job02 *job = pointer;
    const int result = roll_scenes(random, job->scenes, &job->job.growth);
    if (result == 0) {
        roll_inputs_02(random, job);
    }
    return result;
}

int job_02_write_scene(const void *pointer, int k, FILE *file)
{
    JobScene scene = ((const Job02 *)pointer)->scenes[k];
    scene.tree = (KdTree2D){0};  // the probe shall not see what is expected
    return job_scene_write(&scene, k, file);
}
