// The judges of 3D trees: no tree of a submission does harm, whatever is in it.
#include "random.h"
#include "tree3d_subject.h"

TestSuite(tree3d_hostile);

Test(tree3d_hostile, any_number_anywhere_is_survived)
{
    static const u32 numbers[] = {0,  1,  2,  3,  4,          14,         15,         30,
                                  31, 59, 60, 61, 0x7fc00000, 0x7f800000, 0x80000000, 0xfffffffe};
    TreeScene3D scene = subject_open();
    KdTree3D tree = tree_copy(&scene.tree);
    u32 *const arrays[] = {(u32 *)tree.nodes, tree.sphere_ids};
    const size_t lengths[] = {4 * (size_t)tree.n_nodes, tree.n_sphere_ids};
    for (int a = 0; a < 2; a++) {
        for (size_t i = 0; i < lengths[a]; i++) {
            const u32 was = arrays[a][i];
            for (size_t j = 0; j < sizeof numbers / sizeof *numbers; j++) {
                arrays[a][i] = numbers[j];
                (void)judges_against(&scene, &tree);
            }
            arrays[a][i] = was;
        }
    }
    tree3d_free(&tree);
    scene_close(&scene);
}

Test(tree3d_hostile, random_bits_are_survived)
{
    TreeScene3D scene = subject_open();
    Random random = {2};
    for (int round = 0; round < 400; round++) {
        KdTree3D tree = tree_copy(&scene.tree);
        u32 *words = (u32 *)tree.nodes;
        for (u32 i = 0; i < 4 * tree.n_nodes; i++) {
            if (random_integer(&random, 0, 3) == 0) {
                words[i] = random_integer(&random, 0, 1) ? (u32)random_integer(&random, 0, 40)
                                                         : (u32)random_bits(&random);
            }
        }
        (void)judges_against(&scene, &tree);
        tree3d_free(&tree);
    }
    scene_close(&scene);
}

// As many leaves as an answer may hold share one long list: without a bound on what is looked at,
// this would keep the grader busy for hours.
Test(tree3d_hostile, leaves_without_end_are_judged_in_no_time)
{
    enum { N_MANY = 1 << 20, N_LISTED = 1000 };
    TreeScene3D scene = scene_of("random:n=1000,seed=4", (KdTreeLimits){8, 2});
    KdTree3D tree = {.bounds = scene.tree.bounds,
                     .nodes = calloc(N_MANY, sizeof *tree.nodes),
                     .sphere_ids = calloc(N_LISTED, sizeof *tree.sphere_ids),
                     .n_nodes = N_MANY,
                     .n_sphere_ids = N_LISTED};
    for (u32 id = 0; id < N_MANY; id++) {
        tree.nodes[id] = (KdNode3){0, KD_LEAF, 0, N_LISTED};
    }
    for (u32 i = 0; i < N_LISTED; i++) {
        tree.sphere_ids[i] = i;
    }
    const int against = judges_against(&scene, &tree);
    cr_expect_eq(against & (LISTS | PACKING), LISTS | PACKING);
    tree3d_free(&tree);
    scene_close(&scene);
}

Test(tree3d_hostile, an_empty_tree_is_survived)
{
    TreeScene3D scene = subject_open();
    const KdTree3D empty = {0};
    cr_expect_neq(judges_against(&scene, &empty), 0);
    scene_close(&scene);
}
