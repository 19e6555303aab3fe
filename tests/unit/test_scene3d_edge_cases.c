// common/scene3d_edge_cases: each edge case has what it is there for.
#include "scene3d_samples.h"

TestSuite(scene3d_edge_cases, .init = folder_enter, .fini = folder_leave);

Test(scene3d_edge_cases, edge_cases_are_these)
{
    static const char *const NAMES[] = {"inside", "planes",     "one-cell",    "one",
                                        "none",   "coincident", "large-small", "behind"};
    for (int i = 0; i < 8; i++) {
        cr_assert_not_null(scene3d_edge_case(i));
        cr_expect_str_eq(scene3d_edge_case(i), NAMES[i]);
        Scene3D scene = scene_open(NAMES[i]);
        cr_expect_leq(scene.n_spheres, 512);
        scene3d_free(&scene);
    }
    cr_expect_null(scene3d_edge_case(8));
}

Test(scene3d_edge_cases, inside_has_the_eye_in_a_sphere_with_others_in_and_outside)
{
    Scene3D scene = scene_open("inside");
    const Sphere *wall = &scene.spheres[0];
    cr_expect_lt(distance_from_eye(&scene, 0), size_of(&scene, 0));
    int n_in = 0, n_across = 0, n_outside = 0, n_negative = 0;
    for (int i = 1; i < scene.n_spheres; i++) {
        double distance = distance_between(wall, &scene.spheres[i]);
        double size = size_of(&scene, i);
        n_in += distance + size < (double)wall->radius;
        n_outside += distance - size > (double)wall->radius;
        n_across += fabs(distance - (double)wall->radius) < size;
        n_negative += scene.spheres[i].radius < 0;
        cr_expect(distance_from_eye(&scene, i) > size || scene.spheres[i].radius < 0, "%d", i);
    }
    cr_expect(n_in >= 20 && n_across >= 3 && n_outside >= 9 && n_negative == 2, "%d %d %d %d", n_in,
              n_across, n_outside, n_negative);
    scene3d_free(&scene);
}

static const float *centre_of(const Sphere *sphere)
{
    return &sphere->x;  // x, y and z follow each other; see LAYOUT_ASSERT
}

Test(scene3d_edge_cases, planes_has_all_on_halves_and_quarters_of_its_box)
{
    Scene3D scene = scene_open("planes");
    for (int axis = 0; axis < 3; axis++) {
        float lowest = INFINITY, highest = -INFINITY;
        int n_centred = 0, n_below = 0, n_above = 0;  // on planes at -1/2, 0 and 1/2
        for (int i = 0; i < scene.n_spheres; i++) {
            float centre = centre_of(&scene.spheres[i])[axis];
            float radius = scene.spheres[i].radius;
            lowest = fminf(lowest, centre - radius);
            highest = fmaxf(highest, centre + radius);
            n_centred += is_multiple(centre, 0.5f);
            n_below += is_multiple(centre + radius, 0.5f) && fabsf(centre) < 0.6f;
            n_above += is_multiple(centre - radius, 0.5f) && fabsf(centre) < 0.6f;
        }
        cr_expect(lowest == -1 && highest == 1, "axis %d", axis);
        cr_expect(n_centred == 26 && n_below == 12 && n_above == 12, "axis %d: %d %d %d", axis,
                  n_centred, n_below, n_above);
    }
    for (int i = 0; i < scene.n_spheres; i++) {
        cr_expect_gt(distance_from_eye(&scene, i), size_of(&scene, i), "%d is around the eye", i);
        for (int j = 0; j < i; j++) {  // of two that overlap, rounding could choose the nearer
            cr_expect_geq(distance_between(&scene.spheres[i], &scene.spheres[j]),
                          size_of(&scene, i) + size_of(&scene, j), "%d and %d", i, j);
        }
    }
    scene3d_free(&scene);
}

// Rays of the middle column and row stay in planes through the eye, and the eye is on split planes.
Test(scene3d_edge_cases, planes_has_rays_within_its_planes)
{
    Scene3D scene = scene_open("planes");
    const View *view = &scene.view;
    cr_expect(scene.width % 2 == 1 && scene.height % 2 == 1);
    cr_expect(view->from.x == 0.5f && view->from.y == 0 && view->from.z == 0);
    // The camera of lab 04, in float.
    const Vec3 forward = vec3_normalized(vec3_minus(view->at, view->from));
    const Vec3 right = vec3_normalized(vec3_cross(forward, view->up));
    const Vec3 up = vec3_cross(right, forward);
    cr_expect(forward.x == -1 && forward.y == 0 && forward.z == 0);
    cr_expect(right.x == 0 && right.y == 1 && right.z == 0);
    cr_expect(up.x == 0 && up.y == 0 && up.z == 1);
    scene3d_free(&scene);
}

// No ray of the picture grazes a sphere so closely that rounding in float decides about the pixel.
Test(scene3d_edge_cases, planes_leaves_no_pixel_to_rounding)
{
    Scene3D scene = scene_open("planes");
    const Axes axes = axes_of(&scene.view);
    const double spacing =
        (double)scene3d_fov(&scene.view, scene.width, scene.height) / scene.width;
    double closest = INFINITY;
    for (int pixel = 0; pixel < scene.width * scene.height; pixel++) {
        double ray[3];
        ray_towards(&axes, spacing, pixel % scene.width - scene.width / 2,
                    scene.height / 2 - pixel / scene.width, ray);
        double ray2 = ray[0] * ray[0] + ray[1] * ray[1] + ray[2] * ray[2];
        for (int i = 0; i < scene.n_spheres; i++) {
            const Sphere *sphere = &scene.spheres[i];
            double to[3] = {(double)sphere->x - scene.view.from.x,
                            (double)sphere->y - scene.view.from.y,
                            (double)sphere->z - scene.view.from.z};
            double along = (to[0] * ray[0] + to[1] * ray[1] + to[2] * ray[2]) / ray2;
            double off2 = 0;  // the squared distance of the centre from the ray
            for (int axis = 0; axis < 3; axis++) {
                off2 += pow(to[axis] - along * ray[axis], 2);
            }
            double radius2 = pow((double)sphere->radius, 2);
            closest = along > 0 ? fmin(closest, fabs(off2 - radius2)) : closest;
        }
    }
    // Squares of distances up to 2 are rounded in float by 2^-22, a few times over.
    cr_expect_gt(closest, 1e-6, "%g", closest);
    scene3d_free(&scene);
}

Test(scene3d_edge_cases, one_cell_holds_all_spheres_but_one)
{
    Scene3D scene = scene_open("one-cell");
    int n_in_cell = 0;
    for (int i = 0; i < scene.n_spheres; i++) {
        const float *centre = centre_of(&scene.spheres[i]);
        float side = 1.0f / 400;  // the box is more than 3 wide
        n_in_cell += fabsf(centre[0] - 1) < side && fabsf(centre[1] - 1) < side &&
                     fabsf(centre[2] - 1) < side;
        cr_expect_gt(distance_from_eye(&scene, i), size_of(&scene, i));
    }
    cr_expect(n_in_cell == scene.n_spheres - 1 && n_in_cell >= 200, "%d", n_in_cell);
    scene3d_free(&scene);
}

// How many spheres share the centre of sphere i, and how many of those its radius; i included.
static void count_equals(const Scene3D *scene, int i, int *n_places, int *n_radii)
{
    *n_places = *n_radii = 0;
    for (int j = 0; j < scene->n_spheres; j++) {
        int same = distance_between(&scene->spheres[i], &scene->spheres[j]) == 0;
        *n_places += same;
        *n_radii += same && scene->spheres[i].radius == scene->spheres[j].radius;
    }
}

Test(scene3d_edge_cases, coincident_has_equal_and_different_radii)
{
    static const int N_WITH_THE_RADIUS[3] = {64, 1, 4};
    Scene3D scene = scene_open("coincident");
    cr_assert_eq(scene.n_spheres, 3 * 64);
    for (int i = 0; i < scene.n_spheres; i++) {
        int n_places, n_radii;
        count_equals(&scene, i, &n_places, &n_radii);
        cr_expect(n_places == 64 && n_radii == N_WITH_THE_RADIUS[i / 64], "%d: %d %d", i, n_places,
                  n_radii);
    }
    // Whose material is seen, must show: of equal spheres each has another than its neighbours.
    cr_expect_neq(scene.material_ids[0], scene.material_ids[1]);
    scene3d_free(&scene);
}

Test(scene3d_edge_cases, large_small_has_radii_far_apart)
{
    Scene3D scene = scene_open("large-small");
    double smallest = INFINITY, largest = 0;
    for (int i = 0; i < scene.n_spheres; i++) {
        smallest = fmin(smallest, size_of(&scene, i));
        largest = fmax(largest, size_of(&scene, i));
        cr_expect_gt(distance_from_eye(&scene, i), size_of(&scene, i));
    }
    cr_expect_geq(largest / smallest, 10000);
    scene3d_free(&scene);
}

Test(scene3d_edge_cases, behind_has_spheres_on_all_sides_of_the_eye)
{
    Scene3D scene = scene_open("behind");
    const Vec3 forward = vec3_minus(scene.view.at, scene.view.from);
    int n_behind = 0, n_before = 0;
    double nearest_behind = INFINITY, nearest_before = INFINITY;
    for (int i = 0; i < scene.n_spheres; i++) {
        const Sphere *sphere = &scene.spheres[i];
        Vec3 to = vec3_minus((Vec3){sphere->x, sphere->y, sphere->z}, scene.view.from);
        double gap = distance_from_eye(&scene, i) - size_of(&scene, i);
        cr_expect_gt(gap, 0, "%d is around the eye", i);
        if (vec3_dot(to, forward) > 0) {
            n_before++;
            nearest_before = fmin(nearest_before, gap);
        } else {
            n_behind++;
            nearest_behind = fmin(nearest_behind, gap);
        }
    }
    cr_expect(n_before >= 10 && n_behind >= 20, "%d %d", n_before, n_behind);
    cr_expect_lt(nearest_behind, nearest_before);
    scene3d_free(&scene);
}
