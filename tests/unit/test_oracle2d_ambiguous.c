// judge/oracle2d: honest about what float cannot decide.
#include "oracle2d.h"
#include "random.h"
#include "scene2d.h"
#include "surroundings.h"

#include <math.h>

TestSuite(oracle2d_ambiguous);

static const OracleRules RIGHT = {0};

// How many pixels of a scene the oracle leaves open.
static int count_ambiguous(const Scene2D *scene)
{
    const size_t n_pixels = (size_t)scene->width * (size_t)scene->height;
    unsigned char *ambiguous = malloc(n_pixels);
    Image image;
    cr_assert_eq(image_create(scene->width, scene->height, &image), 0);
    memset(ambiguous, 7, n_pixels);
    oracle2d_draw(scene->circles, scene->n_circles, &RIGHT, &image, ambiguous);
    int n = 0;
    for (size_t i = 0; i < n_pixels; i++) {
        cr_assert(ambiguous[i] <= 1);
        n += ambiguous[i];
    }
    image_free(&image);
    free(ambiguous);
    return n;
}

Test(oracle2d_ambiguous, nothing_is_ambiguous_on_the_grid)
{
    static const int sizes[][2] = {{64, 48}, {48, 64}, {96, 64}, {317, 211},
                                   {1, 1},   {3, 200}, {10, 10}};
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++) {
        Scene2D scene;
        for (int j = 0; scene2d_edge_case(j) != NULL; j++) {
            cr_assert_eq(scene2d_open(scene2d_edge_case(j), sizes[i][0], sizes[i][1], &scene), 0);
            cr_expect_eq(count_ambiguous(&scene), 0, "%s", scene2d_edge_case(j));
            scene2d_free(&scene);
        }
        for (uint64_t seed = 0; seed < 5; seed++) {
            cr_assert_eq(scene2d_random(50, seed, 0, (float)(10 + 60 * seed), sizes[i][0],
                                        sizes[i][1], &scene),
                         0);
            cr_expect_eq(count_ambiguous(&scene), 0, "seed %d", (int)seed);
            scene2d_free(&scene);
        }
    }
}

enum { WIDTH = 48, HEIGHT = 32, N_CIRCLES = 40 };

static float anywhere(Random *random, double lowest, double highest)
{
    return (float)(lowest + (highest - lowest) * (double)(random_bits(random) >> 11) * 0x1p-53);
}

// Circles off the grid whose boundaries pass as near to a pixel as a float radius can say.
static void draw_off_grid(Random *random, Circle circles[N_CIRCLES])
{
    for (int i = 0; i < N_CIRCLES; i++) {
        const float x = anywhere(random, -9, WIDTH + 9), y = anywhere(random, -9, HEIGHT + 9);
        const double u = (double)random_integer(random, 0, WIDTH - 1);
        const double v = (double)random_integer(random, 0, HEIGHT - 1);
        circles[i] = (Circle){.x = x,
                              .y = y,
                              .radius = (float)hypot(u - x, v - y),
                              .depth = (float)random_integer(random, 0, 9) / 8,
                              .r = (float)(i + 1)};
    }
}

// Ways in which a right renderer may compute coverage in float.
enum { N_WAYS = 6 };
static int covers_in_float(int way, Circle c, float x, float y)
{
    const float dx = x - c.x, dy = y - c.y;
    switch (way) {
    case 0:
        return dx * dx + dy * dy <= c.radius * c.radius;
    case 1:
        return fmaf(dx, dx, dy * dy) <= c.radius * c.radius;
    case 2:
        return fmaf(dy, dy, dx * dx) <= c.radius * c.radius;
    case 3:
        return dx * dx + dy * dy - c.radius * c.radius <= 0;
    case 4:
        return fmaf(-c.radius, c.radius, dx * dx + dy * dy) <= 0;
    default:
        return fmaf(-c.radius, c.radius, fmaf(dx, dx, dy * dy)) <= 0;
    }
}

static float colour_in_float(int way, const Circle *circles, int x, int y)
{
    float min_depth = INFINITY, colour = 0;
    for (int i = 0; i < N_CIRCLES; i++) {
        if (circles[i].depth < min_depth && covers_in_float(way, circles[i], (float)x, (float)y)) {
            min_depth = circles[i].depth;
            colour = circles[i].r;
        }
    }
    return colour;
}

Test(oracle2d_ambiguous, what_float_decides_otherwise_is_ambiguous)
{
    Random random = {5};
    Image image;
    cr_assert_eq(image_create(WIDTH, HEIGHT, &image), 0);
    int n_different = 0, n_ambiguous = 0;
    for (int round = 0; round < 50; round++) {
        Circle circles[N_CIRCLES];
        unsigned char ambiguous[HEIGHT][WIDTH];
        draw_off_grid(&random, circles);
        oracle2d_draw(circles, N_CIRCLES, &RIGHT, &image, ambiguous[0]);
        for (int y = 0; y < HEIGHT; y++) {
            for (int x = 0; x < WIDTH; x++) {
                const float expected = image.pixels[(y * WIDTH + x) * IMAGE_CHANNELS];
                n_ambiguous += ambiguous[y][x];
                for (int way = 0; way < N_WAYS; way++) {
                    const int differs = colour_in_float(way, circles, x, y) != expected;
                    n_different += differs;
                    cr_expect(!differs || ambiguous[y][x], "round %d, pixel (%d, %d), way %d",
                              round, x, y, way);
                }
            }
        }
    }
    // Else nothing was tried, or too much is let pass.
    cr_expect_gt(n_different, 100);
    cr_expect(n_ambiguous > 1000 && n_ambiguous <= 50 * N_CIRCLES + 100, "%d", n_ambiguous);
    image_free(&image);
}

Test(oracle2d_ambiguous, no_rounding_of_a_single_circle_is_overlooked)
{
    Random random = {6};
    Image image;
    cr_assert_eq(image_create(1, 1, &image), 0);
    int n_different = 0;
    for (int i = 0; i < 400000; i++) {
        // The one pixel of the image is sampled at (place, place). Just above 512 the steps of
        // float are largest against the numbers, and centres near 0 make every step round.
        const int is_worst = i % 2;
        const OracleRules rules = {.sample_offset =
                                       is_worst ? 514 : (double)random_integer(&random, 0, 999)};
        const float place = (float)rules.sample_offset;
        Circle circle = {.x = anywhere(&random, is_worst ? 0 : -99, is_worst ? 2 : 1099),
                         .y = anywhere(&random, is_worst ? 0 : -99, is_worst ? 2 : 1099)};
        circle.radius = (float)hypot((double)place - circle.x, (double)place - circle.y);
        const int nudge = (int)random_integer(&random, -1, 1);
        circle.radius = nudge ? nextafterf(circle.radius, (float)nudge * INFINITY) : circle.radius;
        unsigned char ambiguous;
        oracle2d_draw(&circle, 1, &rules, &image, &ambiguous);
        for (int way = 0; way < N_WAYS; way++) {
            const int differs =
                covers_in_float(way, circle, place, place) != oracle2d_covers(circle, place, place);
            n_different += differs;
            cr_expect(!differs || ambiguous, "circle (%a, %a) %a at %g, way %d", (double)circle.x,
                      (double)circle.y, (double)circle.radius, (double)place, way);
        }
    }
    cr_expect_gt(n_different, 1000);
    image_free(&image);
}

Test(oracle2d_ambiguous, what_float_cannot_hold_is_ambiguous)
{
    // Squares that overflow to infinity, and squares that vanish.
    static const Circle circles[] = {{.x = 1e30f, .radius = 5e29f},
                                     {.x = 3, .y = 1e25f, .radius = 1e24f},
                                     {.x = 1e-25f, .radius = 1e-30f}};
    for (size_t i = 0; i < sizeof circles / sizeof *circles; i++) {
        Image image;
        unsigned char ambiguous;
        cr_assert_eq(image_create(1, 1, &image), 0);
        oracle2d_draw(&circles[i], 1, &RIGHT, &image, &ambiguous);
        cr_expect_not(oracle2d_covers(circles[i], 0, 0));
        cr_expect(covers_in_float(0, circles[i], 0, 0), "float would not be wrong here");
        cr_expect(ambiguous, "circle %zu", i);
        image_free(&image);
    }
}
