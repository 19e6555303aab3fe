// The drawing of a cut through a 3D tree: what is where, and edge cases.
#include "kdtree3d_build.h"
#include "scene3d.h"
#include "surroundings.h"

#include <math.h>

// The drawing is compiled in here with memory that runs out when a test wants it to.
static int has_memory = 1;
#define malloc(n_bytes) (has_memory ? malloc(n_bytes) : NULL)
#include "tree3d_draw.c"
#undef malloc

TestSuite(tree3d_draw);

// Draw a scene of scene3d.h; every value is a colour's.
static Image draw(const char *name, int width, int height, KdTreeLimits limits)
{
    Scene3D scene;
    KdTree3D tree;
    Image image;
    cr_assert_eq(scene3d_open(name, width, height, &scene), 0);
    cr_assert_eq(kdtree3d_build(scene.spheres, (u32)scene.n_spheres, limits, &tree), 0);
    cr_assert_eq(tree3d_draw(&scene, &tree, &image), 0);
    cr_assert(image.width == scene.width && image.height == scene.height);
    for (int i = 0; i < image.width * image.height * IMAGE_CHANNELS; i++) {
        cr_assert(image.pixels[i] >= 0 && image.pixels[i] <= 1, "%s: %g", name,
                  (double)image.pixels[i]);
        cr_assert(i % IMAGE_CHANNELS != 3 || image.pixels[i] == 1, "opaque");
    }
    tree3d_free(&tree);
    scene3d_free(&scene);
    return image;
}

static const float *pixel_of(const Image *image, int u, int v)
{
    return image->pixels + ((size_t)v * image->width + u) * IMAGE_CHANNELS;
}

static int is_background(const float *pixel)
{
    return memcmp(pixel, BACKGROUND, sizeof BACKGROUND) == 0;
}

static int count_background(const Image *image)
{
    int n = 0;
    for (int i = 0; i < image->width * image->height; i++) {
        n += is_background(image->pixels + (size_t)i * IMAGE_CHANNELS);
    }
    return n;
}

Test(tree3d_draw, an_empty_scene_is_plain_background)
{
    Image image = draw("none", 64, 48, (KdTreeLimits){5, 1});
    cr_expect_eq(count_background(&image), 64 * 48);
    image_free(&image);
}

Test(tree3d_draw, a_tree_without_nodes_is_plain_background)
{
    Scene3D scene;
    const KdTree3D tree = {.bounds = {{-1, -1, -1}, {1, 1, 1}}};
    Image image;
    cr_assert_eq(scene3d_open("one", 64, 48, &scene), 0);
    cr_assert_eq(tree3d_draw(&scene, &tree, &image), 0);
    cr_expect_eq(count_background(&image), 64 * 48);
    image_free(&image);
    scene3d_free(&scene);
}

Test(tree3d_draw, edge_cases_are_drawn_at_any_size)
{
    static const int sizes[][2] = {{1, 1}, {1, 40}, {40, 1}, {2, 3}, {65, 49}};
    for (int i = 0; scene3d_edge_case(i) != NULL; i++) {
        for (size_t j = 0; j < sizeof sizes / sizeof *sizes; j++) {
            Image image =
                draw(scene3d_edge_case(i), sizes[j][0], sizes[j][1], (KdTreeLimits){9, 8});
            image_free(&image);
        }
    }
}

// One sphere: a square box, a disc in the middle in the sphere's colour, cell in the corners.
Test(tree3d_draw, one_sphere_is_a_disc_in_a_square)
{
    enum { WIDTH = 200, HEIGHT = 100, MARGIN_PIXELS = 5 };
    Scene3D scene;
    cr_assert_eq(scene3d_open("one", WIDTH, HEIGHT, &scene), 0);
    const Vec3 color = scene.materials[scene.material_ids[0]].color;
    scene3d_free(&scene);
    Image image = draw("one", WIDTH, HEIGHT, (KdTreeLimits){1, 1});
    const int side = HEIGHT - 2 * MARGIN_PIXELS;
    cr_expect_lt(abs(WIDTH * HEIGHT - side * side - count_background(&image)), 3 * side,
                 "square, with a margin");
    cr_expect(is_background(pixel_of(&image, 40, 50)) && is_background(pixel_of(&image, 160, 50)));
    const float *middle_pixel = pixel_of(&image, 100, 50), *corner = pixel_of(&image, 60, 10);
    cr_expect_float_eq(middle_pixel[0], CIRCLE_OPACITY * color.x + (1 - CIRCLE_OPACITY) * corner[0],
                       1e-5);
    cr_expect(!is_background(corner) && corner[0] != middle_pixel[0]);
    image_free(&image);
}

// x to the right, z upwards: the box is flat in y.
Test(tree3d_draw, the_shortest_side_points_at_the_viewer)
{
    Sphere spheres[] = {{-8, 0, -4, 1}, {8, 0, 4, 1}, {8, 0, -4, 1}};
    u32 material_ids[] = {0, 1, 2};
    Material materials[] = {{.color = {1, 0, 0}}, {.color = {0, 1, 0}}, {.color = {0, 0, 1}}};
    const Scene3D scene = {.spheres = spheres,
                           .material_ids = material_ids,
                           .materials = materials,
                           .n_spheres = 3,
                           .n_materials = 3,
                           .width = 200,
                           .height = 200};
    KdTree3D tree;
    Image image;
    // 18 wide and 10 high: 10 pixels a unit.
    cr_assert_eq(kdtree3d_build(spheres, 3, (KdTreeLimits){1, 1}, &tree), 0);
    cr_assert_eq(tree3d_draw(&scene, &tree, &image), 0);
    cr_expect_gt(pixel_of(&image, 20, 140)[0], 0.7f, "red: left and below");
    cr_expect_gt(pixel_of(&image, 180, 60)[1], 0.7f, "green: right and above");
    cr_expect_gt(pixel_of(&image, 180, 140)[2], 0.7f, "blue: right and below");
    image_free(&image);
    tree3d_free(&tree);
}

Test(tree3d_draw, fuller_cells_are_brighter)
{
    // Far apart: the left half holds one sphere, the right one four.
    Sphere spheres[] = {{-8, 0, 0, 1}, {7, 0, 7, 1}, {7, 0, -7, 1}, {8, 0, 3, 1}, {8, 0, -3, 1}};
    u32 material_ids[5] = {0};
    Material material = {.color = {1, 1, 1}};
    const Scene3D scene = {.spheres = spheres,
                           .material_ids = material_ids,
                           .materials = &material,
                           .n_spheres = 5,
                           .n_materials = 1,
                           .width = 180,
                           .height = 160};
    KdTree3D tree;
    Image image;
    cr_assert_eq(kdtree3d_build(spheres, 5, (KdTreeLimits){2, 1}, &tree), 0);
    cr_assert_eq(tree.n_nodes, 3);
    cr_assert_eq(tree3d_draw(&scene, &tree, &image), 0);
    const float *left = pixel_of(&image, 60, 120), *right = pixel_of(&image, 110, 81);
    cr_expect_gt(right[0], left[0] + 0.1f);
    image_free(&image);
    tree3d_free(&tree);
}

// Between two layers of a lattice there is nothing to see: the cut moves to the nearest centre.
Test(tree3d_draw, the_cut_meets_a_sphere_where_there_is_one)
{
    Scene3D scene;
    KdTree3D tree;
    Cut cut;
    cr_assert_eq(scene3d_open("lattice:n=4", 64, 64, &scene), 0);
    cr_assert_eq(kdtree3d_build(scene.spheres, 64, (KdTreeLimits){5, 2}, &tree), 0);
    cr_assert_eq(place_cut(&scene, &tree, &cut), 0);
    int n_cut = 0;
    for (int i = 0; i < 64; i++) {
        CutCircle circle;
        n_cut += cut_sphere(&cut, i, &circle);
    }
    cr_expect_eq(n_cut, 16);
    tree3d_free(&tree);
    scene3d_free(&scene);
}

// The grader draws what a submission says that its box and planes are.
Test(tree3d_draw, any_box_and_any_plane_are_survived)
{
    static const float numbers[] = {NAN, INFINITY, -INFINITY, 3e38f, -3e38f, 1e-40f, 0, 1e9f};
    enum { N_NUMBERS = sizeof numbers / sizeof *numbers };
    Scene3D scene;
    KdTree3D tree;
    cr_assert_eq(scene3d_open("random:n=40", 40, 30, &scene), 0);
    cr_assert_eq(kdtree3d_build(scene.spheres, 40, (KdTreeLimits){6, 2}, &tree), 0);
    const BBox3D bounds = tree.bounds;
    for (int i = 0; i < 6 * N_NUMBERS * N_NUMBERS; i++) {
        Image image;
        tree.bounds = bounds;
        float *sides[] = {&tree.bounds.min[0], &tree.bounds.max[0], &tree.bounds.min[1],
                          &tree.bounds.max[1], &tree.bounds.min[2], &tree.bounds.max[2]};
        *sides[i % 6] = numbers[i / 6 % N_NUMBERS];
        *sides[(i + 3) % 6] = numbers[i / 6 / N_NUMBERS];
        tree.nodes[0].split_pos = numbers[i % N_NUMBERS];
        cr_assert_eq(tree3d_draw(&scene, &tree, &image), 0);
        image_free(&image);
    }
    tree3d_free(&tree);
    scene3d_free(&scene);
}

Test(tree3d_draw, memory_that_runs_out_is_told)
{
    Scene3D scene;
    KdTree3D tree;
    Image image;
    cr_assert_eq(scene3d_open("one", 64, 48, &scene), 0);
    cr_assert_eq(kdtree3d_build(scene.spheres, 1, (KdTreeLimits){1, 1}, &tree), 0);
    capture_begin(2);
    has_memory = 0;
    const int result = tree3d_draw(&scene, &tree, &image);
    has_memory = 1;
    expect_one_message(capture_end(2), "tree3d_draw: no memory for 1 circles");
    cr_expect_eq(result, -1);
    tree3d_free(&tree);
    scene3d_free(&scene);
}
