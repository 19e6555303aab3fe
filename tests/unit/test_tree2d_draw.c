// common/tree2d_draw: the tree as a picture and as SVG.
#include "random.h"
#include "tree2d_subject.h"

#include <math.h>

TestSuite(tree2d_draw);

Test(tree2d_draw, any_box_is_drawn_or_left_out)
{
    static const float numbers[] = {NAN,    -NAN, INFINITY, -INFINITY,     3e38f, -3e38f,
                                    1e-40f, 1e9f, -1e9f,    2147483648.0f, 0,     12.5f};
    enum { N_NUMBERS = sizeof numbers / sizeof *numbers };
    JobScene scene = subject_open();
    Random random = {3};
    KdTree2D tree = tree_copy(&scene.tree);
    for (int round = 0; round < 20; round++) {
        float *values = (float *)tree.nodes_BBox;
        for (size_t i = 0; i < 4 * tree.n_nodes; i++) {
            values[i] = numbers[random_integer(&random, 0, N_NUMBERS - 1)];
        }
        survive(&scene, &tree);
        Image image;
        cr_assert_eq(tree2d_draw(&scene.scene, &tree, &image), 0);
        cr_expect(image.width == 640 && image.height == 480);
        for (int i = 0; i < 640 * 480 * IMAGE_CHANNELS; i++) {
            cr_assert(image.pixels[i] >= 0 && image.pixels[i] <= 1);
        }
        image_free(&image);
    }
    tree2d_free(&tree);
    job_scene_free(&scene);
}

// How many pixels of the drawing have a cell border's colour.
static int count_border_pixels(const Scene2D *scene, const KdTree2D *tree)
{
    Image image;
    cr_assert_eq(tree2d_draw(scene, tree, &image), 0);
    int n = 0;
    for (int i = 0; i < image.width * image.height; i++) {
        n += image.pixels[IMAGE_CHANNELS * i + 2] == 0.92f;
    }
    image_free(&image);
    return n;
}

Test(tree2d_draw, cells_are_drawn_where_they_are)
{
    // The example's root is the picture, 64 times magnified: eight cells on the last level, 2.5 by
    // 5.
    JobScene scene = scene_of("example", 10, 10, (KdTreeLimits){4, 1});
    cr_expect_eq(count_border_pixels(&scene.scene, &scene.tree), 4 * 640 + 2 * 640 - 4 * 2,
                 "four vertical lines cross two horizontal ones");
    char *svg = NULL;
    size_t n_bytes;
    FILE *file = open_memstream(&svg, &n_bytes);
    cr_assert_eq(tree2d_write_svg(file, &scene.scene, &scene.tree), 0);
    fclose(file);
    cr_expect_not_null(strstr(svg, "M320 320H480V640H320z"), "node 13's cell");
    cr_expect_not_null(strstr(svg, ">13</text>"));
    cr_expect_null(strstr(svg, ">6</text>"), "an inner node has no cell of its own");
    free(svg);
    job_scene_free(&scene);
}

Test(tree2d_draw, an_svg_that_cannot_be_written_is_told)
{
    JobScene scene = subject_open();
    FILE *full = fopen("/dev/full", "w");
    cr_assert_not_null(full);
    setvbuf(full, NULL, _IONBF, 0);
    cr_expect_eq(tree2d_write_svg(full, &scene.scene, &scene.tree), -1);
    fclose(full);
    job_scene_free(&scene);
}
