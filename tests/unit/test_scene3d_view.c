// common/scene3d_view: the field of view, which views a camera can have, and the smallest angle.
#include "random.h"
#include "scene3d_samples.h"

#include <float.h>

TestSuite(scene3d_view, .init = folder_enter, .fini = folder_leave);

Test(scene3d_view, fov_follows_the_rows)
{
    View view = {.angle = 90};
    cr_expect_float_eq(scene3d_fov(&view, 1, 2), 2.0f, 1e-6f);  // from -1 to 1 in one step
    cr_expect_float_eq(scene3d_fov(&view, 3, 2), 6.0f, 1e-6f);
    cr_expect_float_eq(scene3d_fov(&view, 640, 481), 640 / 240.0f, 1e-6f);
    cr_expect_float_eq(scene3d_fov(&view, 5, 1), 10.0f, 1e-5f, "one row is as two");
    view.angle = 45;
    cr_expect_float_eq(scene3d_fov(&view, 512, 513), 2 * (sqrtf(2) - 1), 1e-6f);
}

#define OUT_OF_RANGE "the view's direction or up is too short or too long (1e-32 to 1e32)"

// Exact values stand for themselves; 1e30 and 1e-30 overflow and vanish when squared in float.
static const struct {
    Vec3 from, at, up;
    const char *fault;
} VIEWS[] = {
    {{0, 0, 0}, {1, 0, 0}, {0, 0, 1}, NULL},
    {{0, 0, 0}, {1, 0, 0}, {0, 0, 1e-30f}, NULL},
    {{0, 0, 0}, {1, 0, 0}, {0, 0, 1e30f}, NULL},
    {{0, 0, 0}, {1e30f, 0, 0}, {0, 0, 1}, NULL},
    {{0, 0, 0}, {1e-30f, 0, 0}, {0, 0, 1}, NULL},
    {{0, 0, 0}, {1e-30f, 0, 0}, {0, 1e-30f, 0}, NULL},
    {{3e38f, 0, 0}, {-3e38f, 0, 0}, {0, 1, 0}, OUT_OF_RANGE},
    {{0, 0, 0}, {1e-45f, 0, 0}, {0, 0, 1}, OUT_OF_RANGE},
    {{1e-30f, 0, 0}, {0, 0, 0}, {0, 3e38f, 0}, OUT_OF_RANGE},
    {{0, 0, 0}, {1, 0, 0}, {0, 1e-33f, 0}, OUT_OF_RANGE},
    {{1, 2, 3}, {4, 5, 6}, {1, 1, 1.001f}, NULL},
    {{1, 2, 3}, {1, 2, 3}, {0, 0, 1}, "the view's direction is zero (from is at)"},
    {{1e30f, 0, 0}, {1e30f, 0, 0}, {0, 0, 1}, "the view's direction is zero (from is at)"},
    {{1, 2, 3}, {1, 2, 3}, {0, 0, 0}, "the view's direction is zero (from is at)"},
    {{1, 2, 3}, {0, 0, 0}, {0, 0, 0}, "up is zero"},
    {{1, 2, 3}, {0, 0, 0}, {0, -0.0f, 0}, "up is zero"},
    {{0, 0, 5}, {0, 0, 0}, {0, 0, 1}, "up is parallel to the view"},
    {{0, 0, 0}, {0, 0, 5}, {0, 0, 1}, "up is parallel to the view"},
    {{1, 2, 3}, {4, 5, 6}, {-2, -2, -2}, "up is parallel to the view"},
    {{1, 2, 3}, {4, 5, 6}, {1, 1, 1.0001f}, "up is parallel to the view"},
    {{0, 0, 0}, {0, 1e30f, 0}, {0, 1e-30f, 0}, "up is parallel to the view"},
    {{0, 0, 0}, {1e31f, 1e31f, 0}, {1e31f, 1e31f, 0}, "up is parallel to the view"},
    {{0, 0, 0}, {0, 1e-31f, 0}, {0, 1e-31f, 0}, "up is parallel to the view"},
};

Test(scene3d_view, views_that_do_not_work_are_told)
{
    for (size_t i = 0; i < sizeof VIEWS / sizeof VIEWS[0]; i++) {
        View view = {VIEWS[i].from, VIEWS[i].at, VIEWS[i].up, 45, 0};
        const char *fault = scene3d_view_fault(&view);
        if (VIEWS[i].fault == NULL) {
            cr_expect_null(fault, "view %zu: %s", i, fault);
        } else {
            cr_assert_not_null(fault, "view %zu", i);
            cr_expect_str_eq(fault, VIEWS[i].fault, "view %zu: %s", i, fault);
        }
    }
}

// Do two rays, half a pixel to this side of the view's axis and to that, differ in float? So the
// kernels compute them.
static int are_rays_distinct(const Axes *axes, const double sideways[3], double spacing)
{
    int are_distinct = 0;
    for (int i = 0; i < 3; i++) {
        const float forward = (float)axes->forward[i], side = (float)sideways[i];
        const volatile float here = forward + 0.5f * (float)spacing * side;
        const volatile float there = forward - 0.5f * (float)spacing * side;
        are_distinct |= here != there;
    }
    return are_distinct;
}

// At the smallest angle, and the rounding of it, neighbours differ; at less than half of it the
// larger half of a number's spacing is not reached, and they do not.
Test(scene3d_view, the_smallest_angle_keeps_neighbouring_rays_apart)
{
    static const View OBLIQUE[] = {
        {.from = {2.1f, 1.3f, 1.7f}, .up = {0, 0, 1}},
        {.from = {-3, 7, 0.3f}, .up = {0, 1, 0}},
        {.from = {100, 101, 102}, .up = {1, 2, 0}},
    };
    for (size_t i = 0; i < sizeof OBLIQUE / sizeof OBLIQUE[0]; i++) {
        const Axes axes = axes_of(&OBLIQUE[i]);
        for (int height = 2; height <= 4096; height *= 8) {
            const double angle = scene3d_smallest_angle(&OBLIQUE[i], height);
            const double spacing = 2 * tan(angle / 2 * M_PI / 180) / (height - 1);
            cr_expect(are_rays_distinct(&axes, axes.right, 1.01 * spacing), "view %zu", i);
            cr_expect(are_rays_distinct(&axes, axes.up, 1.01 * spacing), "view %zu", i);
            cr_expect(!are_rays_distinct(&axes, axes.right, 0.49 * spacing) ||
                          !are_rays_distinct(&axes, axes.up, 0.49 * spacing),
                      "view %zu: %g is not the smallest angle", i, angle);
        }
    }
    // Along an axis float is as fine as it gets: nothing is refused that could be drawn.
    const View along = {.from = {3000, 0, 0}, .up = {0, 0, 1}};
    cr_expect_lt(scene3d_smallest_angle(&along, 1000), 1e-30);
    cr_expect_gt(scene3d_smallest_angle(&along, 1000), 1.4e-45);
}
