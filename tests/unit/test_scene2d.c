// common/scene2d: names, the example, the edge cases and the random scene.
#include "scene2d.h"
#include "surroundings.h"

#include <math.h>

TestSuite(scene2d, .init = folder_enter, .fini = folder_leave);

static Scene2D scene_open(const char *name, int width, int height)
{
    Scene2D scene;
    cr_assert_eq(scene2d_open(name, width, height, &scene), 0, "%s", name);
    return scene;
}

// Is the point inside or on the circle? In double, where these numbers are exact.
static int circle_covers(const Circle *circle, double x, double y)
{
    double dx = x - circle->x;
    double dy = y - circle->y;
    return dx * dx + dy * dy <= (double)circle->radius * circle->radius;
}

// ---- Every generated scene ----------------------------------------------------------------------

static int is_on_grid(float pixels)
{
    return pixels * 16 == floorf(pixels * 16);
}

static void expect_well_formed(const Scene2D *scene, const char *name)
{
    for (int i = 0; i < scene->n_circles; i++) {
        const Circle *circle = &scene->circles[i];
        cr_expect(is_on_grid(circle->x) && is_on_grid(circle->y) && is_on_grid(circle->radius),
                  "%s: circle %d is off the grid", name, i);
        cr_expect(circle->radius >= 0 && isfinite(circle->depth), "%s: circle %d", name, i);
        cr_expect(circle->radius <= SCENE2D_MAX_RADIUS || circle->radius >= 100000,
                  "%s: circle %d may cross the picture inexactly", name, i);
        cr_expect(circle->r >= 0 && circle->r <= 1 && circle->g >= 0 && circle->g <= 1 &&
                      circle->b >= 0 && circle->b <= 1 && circle->a == 1,
                  "%s: colour of circle %d", name, i);
    }
}

// The promise of the grid: plain float arithmetic decides as exact arithmetic does.
static void expect_exact_in_float(const Scene2D *scene, const char *name)
{
    int step = scene->width > 100 ? 7 : 1;  // of a large picture some pixels will do
    for (int i = 0; i < scene->n_circles; i++) {
        const Circle *circle = &scene->circles[i];
        for (int y = 0; y < scene->height; y += step) {
            for (int x = 0; x < scene->width; x += step) {
                volatile float dx = (float)x - circle->x;
                volatile float dy = (float)y - circle->y;
                volatile float dx2 = dx * dx, dy2 = dy * dy;
                volatile float distance2 = dx2 + dy2, radius2 = circle->radius * circle->radius;
                int separate = distance2 <= radius2;
                int contracted = fmaf(dx, dx, dy2) <= radius2;
                int exact = circle_covers(circle, x, y);
                cr_assert(separate == exact && contracted == exact, "%s: circle %d at (%d, %d)",
                          name, i, x, y);
            }
        }
    }
}

Test(scene2d, every_edge_case_stays_on_the_grid_and_is_exact)
{
    static const int SIZES[][2] = {{64, 48}, {1024, 1024}, {1, 1}, {3, 200}, {1000000, 1}};
    for (int i = 0; scene2d_edge_case(i) != NULL; i++) {
        for (size_t j = 0; j < sizeof SIZES / sizeof SIZES[0]; j++) {
            const char *name = scene2d_edge_case(i);
            Scene2D scene = scene_open(name, SIZES[j][0], SIZES[j][1]);
            cr_expect(scene.width == SIZES[j][0] && scene.height == SIZES[j][1]);
            expect_well_formed(&scene, name);
            if (scene.width <= 1024) {
                expect_exact_in_float(&scene, name);
            }
            scene2d_free(&scene);
        }
    }
}

Test(scene2d, edge_cases_are_the_same_every_time)
{
    for (int i = 0; scene2d_edge_case(i) != NULL; i++) {
        Scene2D first = scene_open(scene2d_edge_case(i), 64, 48);
        Scene2D second = scene_open(scene2d_edge_case(i), 64, 48);
        cr_assert_eq(first.n_circles, second.n_circles);
        if (first.n_circles > 0) {
            size_t n_bytes = (size_t)first.n_circles * sizeof *first.circles;
            cr_expect_eq(memcmp(first.circles, second.circles, n_bytes), 0);
        }
        scene2d_free(&first);
        scene2d_free(&second);
    }
}

Test(scene2d, sizes_where_none_is_given)
{
    Scene2D scene = scene_open("example", 0, 0);
    cr_expect(scene.width == 10 && scene.height == 10);
    scene2d_free(&scene);
    scene = scene_open("borders", 0, 0);
    cr_expect(scene.width == SCENE2D_DEFAULT_SIZE && scene.height == SCENE2D_DEFAULT_SIZE);
    scene2d_free(&scene);
    cr_expect_null(scene.circles);
    scene2d_free(&scene);
}

// ---- The scenes one by one ----------------------------------------------------------------------

Test(scene2d, example_has_the_lectures_circles)
{
    static const float EXPECTED[5][3] = {
        {2.5f, 2.5f, 2}, {3, 7.5f, 1.75f}, {6.5f, 7, 1.75f}, {7.5f, 2.5f, 1.875f}, {5, 4.5f, 1}};
    Scene2D scene = scene_open("example", 0, 0);
    cr_assert_eq(scene.n_circles, 5);
    for (int i = 0; i < 5; i++) {
        const Circle *circle = &scene.circles[i];
        cr_expect(circle->x == EXPECTED[i][0] && circle->y == EXPECTED[i][1] &&
                      circle->radius == EXPECTED[i][2],
                  "circle %c", 'A' + i);
        if (i < 4) {
            cr_expect_gt(circle->depth, scene.circles[4].depth, "E is the nearest");
        }
    }
    // The worked example of the lecture: pixel (7, 7) is in C and not in E.
    cr_expect(circle_covers(&scene.circles[2], 7, 7));
    cr_expect_not(circle_covers(&scene.circles[4], 7, 7));
    scene2d_free(&scene);
}

Test(scene2d, equal_depths_are_decided_by_ties_at_most_pixels)
{
    Scene2D scene = scene_open("equal-depths", 64, 48);
    int n_ties = 0;
    for (int y = 0; y < 48; y++) {
        for (int x = 0; x < 64; x++) {
            float nearest = INFINITY;
            int n_nearest = 0;
            for (int i = 0; i < scene.n_circles; i++) {
                if (!circle_covers(&scene.circles[i], x, y) || scene.circles[i].depth > nearest) {
                    continue;
                }
                n_nearest = scene.circles[i].depth == nearest ? n_nearest + 1 : 1;
                nearest = scene.circles[i].depth;
            }
            n_ties += n_nearest > 1;
        }
    }
    cr_expect_gt(n_ties, 64 * 48 / 2);
    scene2d_free(&scene);
}

// Pixels exactly on a boundary, of all circles together.
static int count_pixels_on_boundaries(const Scene2D *scene)
{
    int n_pixels = 0;
    for (int i = 0; i < scene->n_circles; i++) {
        for (int y = 0; y < scene->height; y++) {
            for (int x = 0; x < scene->width; x++) {
                double dx = x - scene->circles[i].x;
                double dy = y - scene->circles[i].y;
                double radius = scene->circles[i].radius;
                n_pixels += dx * dx + dy * dy == radius * radius;
            }
        }
    }
    return n_pixels;
}

Test(scene2d, borders_and_touching_have_boundaries_through_pixels)
{
    Scene2D borders = scene_open("borders", 64, 48);
    cr_expect_gt(count_pixels_on_boundaries(&borders), 50);
    scene2d_free(&borders);
    Scene2D touching = scene_open("touching", 64, 48);
    cr_expect_gt(count_pixels_on_boundaries(&touching), 50);
    for (int i = 1; i < touching.n_circles; i++) {
        cr_expect_eq(touching.circles[i].depth, touching.circles[0].depth);
    }
    scene2d_free(&touching);
}

static int count_covered(const Circle *circle, int width, int height)
{
    int n_pixels = 0;
    for (int y = 0; y < height; y++) {
        for (int x = 0; x < width; x++) {
            n_pixels += circle_covers(circle, x, y);
        }
    }
    return n_pixels;
}

Test(scene2d, huge_circles_cover_all_none_or_some)
{
    Scene2D scene = scene_open("huge", 64, 48);
    int n_all = 0, n_none = 0, n_some = 0;
    for (int i = 0; i < scene.n_circles; i++) {
        int n_covered = count_covered(&scene.circles[i], 64, 48);
        n_all += n_covered == 64 * 48;
        n_none += n_covered == 0;
        n_some += n_covered > 0 && n_covered < 64 * 48;
    }
    cr_expect(n_all >= 2 && n_none >= 2 && n_some >= 2, "%d %d %d", n_all, n_none, n_some);
    scene2d_free(&scene);
}

Test(scene2d, tiny_circles_cover_none_one_or_two_pixels)
{
    Scene2D scene = scene_open("tiny", 64, 48);
    int n_with[3] = {0};
    int n_points = 0;
    for (int i = 0; i < scene.n_circles; i++) {
        int n_covered = count_covered(&scene.circles[i], 64, 48);
        if (n_covered < 3) {
            n_with[n_covered]++;
        }
        n_points += scene.circles[i].radius == 0 && n_covered == 1;
    }
    cr_expect(n_with[0] > 5 && n_with[1] > 5 && n_with[2] > 5 && n_points > 5);
    scene2d_free(&scene);
}

Test(scene2d, outside_circles_miss_touch_and_reach_in)
{
    Scene2D scene = scene_open("outside", 64, 48);
    int n_none = 0, n_one = 0, n_more = 0;
    for (int i = 0; i < scene.n_circles; i++) {
        const Circle *circle = &scene.circles[i];
        cr_expect(circle->x < 0 || circle->x > 63 || circle->y < 0 || circle->y > 47);
        int n_covered = count_covered(circle, 64, 48);
        n_none += n_covered == 0;
        n_one += n_covered == 1;
        n_more += n_covered > 1;
    }
    cr_expect(n_none >= 8 && n_one >= 4 && n_more >= 4, "%d %d %d", n_none, n_one, n_more);
    scene2d_free(&scene);
}

Test(scene2d, none_has_no_circles)
{
    Scene2D scene = scene_open("none", 64, 48);
    cr_expect_eq(scene.n_circles, 0);
    cr_expect_null(scene.circles);
    scene2d_free(&scene);
}

// ---- Random -------------------------------------------------------------------------------------

Test(scene2d, random_takes_its_arguments_in_any_order)
{
    Scene2D scene = scene_open("random:max=8,n=500,min=4,seed=3", 64, 48);
    cr_assert_eq(scene.n_circles, 500);
    expect_well_formed(&scene, "random");
    expect_exact_in_float(&scene, "random");
    float smallest = INFINITY, largest = 0;
    for (int i = 0; i < 500; i++) {
        const Circle *circle = &scene.circles[i];
        cr_expect(circle->x >= 0 && circle->x <= 64 && circle->y >= 0 && circle->y <= 48);
        cr_expect(circle->depth >= 0 && circle->depth < 1);
        smallest = fminf(smallest, circle->radius);
        largest = fmaxf(largest, circle->radius);
    }
    cr_expect(smallest == 4 && largest == 8, "%g to %g", (double)smallest, (double)largest);
    scene2d_free(&scene);

    scene = scene_open("random", 0, 0);
    cr_expect_eq(scene.n_circles, SCENE2D_DEFAULT_CIRCLES);
    scene2d_free(&scene);
    scene = scene_open("random:n=0", 0, 0);
    cr_expect_eq(scene.n_circles, 0);
    scene2d_free(&scene);
    scene = scene_open("random:n=9,min=1.03,max=1.03", 0, 0);
    cr_expect_eq(scene.circles[0].radius, 1.0f, "rounded to the grid");
    scene2d_free(&scene);
}

// FNV-1a over the bytes. The number is pinned: a change of the generator would change every picture
// that names a seed, reference images and bench figures among them, and must not slip in unseen.
static uint64_t scene_checksum(const Scene2D *scene)
{
    uint64_t sum = 0xcbf29ce484222325u;
    const unsigned char *bytes = (const unsigned char *)scene->circles;
    for (size_t i = 0; i < (size_t)scene->n_circles * sizeof *scene->circles; i++) {
        sum = (sum ^ bytes[i]) * 0x100000001b3u;
    }
    return sum;
}

Test(scene2d, the_same_seed_gives_the_same_scene_everywhere)
{
    Scene2D scene = scene_open("random:n=100,seed=3", 640, 480);
    cr_expect_eq(scene_checksum(&scene), 0xf263d562df4f34a2u);
    Scene2D other = scene_open("random:n=100,seed=4", 640, 480);
    cr_expect_neq(scene_checksum(&scene), scene_checksum(&other));
    scene2d_free(&scene);
    scene2d_free(&other);
}

// ---- Names that are none ------------------------------------------------------------------------

static const struct {
    const char *name;
    const char *message;
} BAD[] = {
    {"sphere", "equal-depths"},
    {"sphere", "random[:n=N"},
    {"", "found no such scene"},
    {".csv", "found no such scene"},
    {"Example", "found no such scene"},
    {"randomly", "found no such scene"},
    {"missing.csv", "missing.csv: "},
    {"MISSING.CSV", "MISSING.CSV: cannot be read: "},
    {"folder.csv", "folder.csv: cannot be read: found a folder"},
    {"random:", "n=N, seed=S, min=R or max=R"},
    {"random:n", "found \"n\""},
    {"random:n=", "found \"n=\""},
    {"random:n=-1", "found \"n=-1\""},
    {"random:n=1e3", "found \"n=1e3\""},
    {"random:n=10000001", "10000000"},
    {"random:n=1,,seed=2", "found \"\""},
    {"random:n=1,", "found \"\""},
    {"random:count=3", "found \"count=3\""},
    {"random:seed=-1", "found \"seed=-1\""},
    {"random:seed=99999999999999999999", "seed=S"},
    {"random:min=-1", "found \"min=-1\""},
    {"random:max=256", "from 0 to 255"},
    {"random:max=nan", "found \"max=nan\""},
    {"random:max=inf", "found \"max=inf\""},
    {"random:min=5,max=4", "min=5 above max=4"},
    {"random:min=21", "min=21 above max=20"},
    {"random:n=5,n=6", "found \"n=6\", expected each argument once"},
    {"random:seed=5,n=6,seed=5", "found \"seed=5\", expected each argument once"},
    {"random:n=5,n=x", "found \"n=x\", expected each argument once"},
};

Test(scene2d, bad_names_give_one_message)
{
    mkdir("folder.csv", 0777);
    for (size_t i = 0; i < sizeof BAD / sizeof BAD[0]; i++) {
        Scene2D scene;
        cr_expect_eq(WITH_MESSAGE(BAD[i].message, scene2d_open(BAD[i].name, 0, 0, &scene)), -1,
                     "%s was opened", BAD[i].name);
        cr_expect_null(scene.circles);
    }
}
