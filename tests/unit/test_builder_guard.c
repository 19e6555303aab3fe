// Lab 02's builder calls a student's distribute(), and believes what that returns only up to the
// length of the list it was given: beyond, it would read what is no list. The Makefile puts a
// known-wrong answer into the solution. Without the builder's guard the message is another one,
// about a scene that is too large, which it is not.
#include "surroundings.h"

#include "returns-too-many.c"
#include "scene2d.h"

TestSuite(builder_guard);

static void expect_refused(const char *scene_name)
{
    Scene2D scene;
    cr_assert_eq(scene2d_open(scene_name, 0, 0, &scene), 0);
    KdTree2D tree = {.n_nodes = 7};
    cr_expect_eq(WITH_MESSAGE("distribute() returned more circles than the node has",
                              kdtree2d_build(scene.circles, (u32)scene.n_circles,
                                             (KdTreeLimits){16, 8}, &tree)),
                 KD_LONG_CHILD);
    cr_expect(tree.n_nodes == 7 && tree.nodes_flag == NULL, "the tree is left alone");
    scene2d_free(&scene);
}

Test(builder_guard, a_list_longer_than_its_nodes_is_refused)
{
    expect_refused("random:n=100");
    expect_refused("random:n=5000");
}
