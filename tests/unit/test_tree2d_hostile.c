// The judges of 2D trees and the drawing: no tree of a submission does harm, whatever is in it.
#include "random.h"
#include "tree2d_subject.h"

TestSuite(tree2d_hostile);

static const u32 hostile_numbers[] = {
    0, 1, 14, 15, 30, 31, 59, 60, 0x7fffffff, 0x80000000, 0xfffffff0, 0xfffffffe, 0xffffffff};
enum { N_HOSTILE = sizeof hostile_numbers / sizeof *hostile_numbers };

Test(tree2d_hostile, any_number_anywhere_is_survived)
{
    JobScene scene = subject_open();
    KdTree2D tree = tree_copy(&scene.tree);
    u32 *const arrays[] = {(u32 *)tree.nodes_Relations, tree.mapNode2Circles};
    const size_t lengths[] = {4 * tree.n_nodes, tree.n_map};
    for (int a = 0; a < 2; a++) {
        for (size_t i = 0; i < lengths[a]; i++) {
            const u32 was = arrays[a][i];
            for (int j = 0; j < N_HOSTILE; j++) {
                arrays[a][i] = hostile_numbers[j];
                for (size_t k = 0; k < sizeof tree_judges / sizeof *tree_judges; k++) {
                    free(told(tree_judges[k].judge(&scene, &tree)));
                }
            }
            arrays[a][i] = was;
        }
    }
    tree2d_free(&tree);
    job_scene_free(&scene);
}

Test(tree2d_hostile, all_bits_set_and_random_bits_are_survived)
{
    JobScene scene = subject_open();
    Random random = {2};
    capture_begin(2);
    for (int round = 0; round < 400; round++) {
        KdTree2D tree = tree_copy(&scene.tree);
        void *const arrays[] = {tree.nodes_Relations, tree.nodes_flag, tree.nodes_BBox,
                                tree.mapNode2Circles};
        const size_t lengths[] = {tree.n_nodes * sizeof(NodeRel), tree.n_nodes,
                                  tree.n_nodes * sizeof(BBox2D), tree.n_map * sizeof(u32)};
        for (int a = 0; a < 4; a++) {
            // Each array in turn, and all at once; all ones first, then hostile and random numbers.
            if (round % 16 != 0 && (round % 16 & 1 << a) == 0) {
                continue;
            }
            memset(arrays[a], 0xff, lengths[a]);
            for (size_t i = 0; round >= 16 && i < lengths[a] / sizeof(u32); i++) {
                const u32 number = random_integer(&random, 0, 1)
                                       ? hostile_numbers[random_integer(&random, 0, N_HOSTILE - 1)]
                                       : (u32)random_bits(&random);
                memcpy((u32 *)arrays[a] + i, &number, sizeof number);
            }
        }
        survive(&scene, &tree);
        tree2d_free(&tree);
    }
    capture_end(2);
    job_scene_free(&scene);
}

// As many leaves as an answer may hold share one list of n_listed ids.
static void expect_judged(u32 n_listed)
{
    enum { N_NODES = 1 << 19, N_MAP = 1 << 22 };
    JobScene scene = scene_of("random:n=1000,seed=4,max=4", 200, 200, (KdTreeLimits){8, 2});
    KdTree2D tree = {calloc(N_NODES, sizeof(NodeRel)),
                     calloc(N_NODES, 1),
                     calloc(N_NODES, sizeof(BBox2D)),
                     calloc(N_MAP, sizeof(u32)),
                     N_NODES,
                     N_MAP};
    // Far from all circles, and with none of them in the list, each leaf is right by itself.
    for (u32 id = 0; id < N_NODES; id++) {
        tree.nodes_BBox[id] = (BBox2D){-9000, -8999, -9000, -8999};
    }
    memset(tree.mapNode2Circles, 0x7f, N_MAP * sizeof(u32));
    tree.mapNode2Circles[0] = n_listed;
    for (size_t i = 0; i < sizeof tree_judges / sizeof *tree_judges; i++) {
        char *message = told(tree_judges[i].judge(&scene, &tree));
        cr_expect_not_null(message, "%s", tree_judges[i].name);
        free(message);
    }
    tree2d_free(&tree);
    job_scene_free(&scene);
}

// Without a bound on what is looked at, these would keep the grader busy for hours.
Test(tree2d_hostile, leaves_that_share_an_endless_list_are_judged_in_no_time)
{
    expect_judged((1 << 22) - 1);
}

Test(tree2d_hostile, leaves_without_end_are_judged_in_no_time)
{
    expect_judged(1000);
}

Test(tree2d_hostile, an_empty_tree_is_survived)
{
    JobScene scene = subject_open();
    KdTree2D empty = {0};
    survive(&scene, &empty);
    cr_expect_neq(judges_against(&scene, &empty) & (LIMITS | CELLS | OVERLAP | LISTS | PACKING), 0);
    tree2d_free(&empty);
    job_scene_free(&scene);
}
