// common/tree2d: what it says of a tree that cannot be followed, how deep a tree is, and what it
// says when memory runs out. Each fault of a tree is test_tree2d_faults.c's matter.
#include "tree2d_subject.h"

// The tree is compiled in here with memory that runs out when a test wants it to.
#include "scarce_memory.h"

#include "tree2d.c"
#include "tree2d_draw.c"
#undef malloc
#undef calloc
#undef realloc

TestSuite(tree2d);

// The first thing that a student sees: nothing is packed yet.
Test(tree2d, an_inner_node_without_children_is_told_as_what_it_mostly_is)
{
    NodeRel root = {0};
    u8 flag = INNER;
    BBox2D box = {0, 1, 0, 1};
    const KdTree2D tree = {
        .nodes_Relations = &root, .nodes_flag = &flag, .nodes_BBox = &box, .n_nodes = 1};
    cr_expect_eq(WITH_MESSAGE("tree: node 0: marked INNER, but it has no children: was it "
                              "packed as a leaf (pack_leaf)?",
                              tree2d_check(&tree, 0)),
                 -1);
}

Test(tree2d, the_depth_counts_levels)
{
    static const int DEPTHS[] = {1, 2, 5};
    for (size_t i = 0; i < sizeof DEPTHS / sizeof *DEPTHS; i++) {
        JobScene scene = scene_of("random:n=60,seed=3", 256, 200, (KdTreeLimits){DEPTHS[i], 1});
        cr_expect_eq(tree2d_depth(&scene.tree), DEPTHS[i]);
        job_scene_free(&scene);
    }
    const KdTree2D empty = {0};
    cr_expect_eq(tree2d_depth(&empty), 0);
}

Test(tree2d, memory_that_runs_out_beside_the_builder_is_told_once)
{
    JobScene scene = subject_open();
    capture_begin(2);
    n_allocations_left = 0;
    const int depth = tree2d_depth(&scene.tree);
    n_allocations_left = -1;
    expect_one_message(capture_end(2), "tree: no memory for the levels of 31 nodes");
    cr_expect_eq(depth, -1);

    FILE *file = tmpfile();
    capture_begin(2);
    n_allocations_left = 0;
    const int written = tree2d_write_svg(file, &scene.scene, &scene.tree);
    n_allocations_left = -1;
    expect_one_message(capture_end(2), "tree2d_write_svg: no memory for 60 circles");
    cr_expect_eq(written, -1);
    cr_expect_eq(ferror(file), 0, "the stream is as good as before");
    fclose(file);
    job_scene_free(&scene);
}
