// common/follow/flight: how a view moves.
#include "camera_from_view.h"
#include "flight.h"

#include <criterion/criterion.h>

// From (0, -4, 0) towards the origin, z up: right is x, forward is y.
static const View HOME = {.from = {0, -4, 0}, .at = {0, 0, 0}, .up = {0, 0, 2}, .angle = 45};

static View moved(View view, Motion motion)
{
    const Camera axes = camera_from_view(view, 64, 64);
    return flight_move(&view, &HOME, &axes, motion);
}

static void expect_near(Vec3 found, Vec3 expected, const char *what)
{
    cr_expect(vec3_length(vec3_minus(found, expected)) < 1e-5, "%s: found (%g, %g, %g)", what,
              found.x, found.y, found.z);
}

Test(flight, nothing_asked_nothing_moved)
{
    const View view = moved(HOME, (Motion){0});
    expect_near(view.from, HOME.from, "the eye");
    expect_near(view.at, HOME.at, "where it looks");
    cr_expect_eq(view.angle, HOME.angle);
}

Test(flight, a_second_covers_half_the_way_to_the_scene)
{
    const View view = moved(HOME, (Motion){.forward = 1});
    expect_near(view.from, (Vec3){0, -2, 0}, "the eye");
    expect_near(view.at, (Vec3){0, 2, 0}, "what it looks at goes along");
    expect_near(moved(HOME, (Motion){.right = 1}).from, (Vec3){2, -4, 0}, "to the right");
    expect_near(moved(HOME, (Motion){.up = 1}).from, (Vec3){0, -4, 2}, "up");
    expect_near(moved(HOME, (Motion){.notches = 10}).from, (Vec3){0, -2, 0}, "the wheel");
}

Test(flight, turns_stay_where_they_are)
{
    const f32 quarter = (f32)M_PI / 2;
    const View right = moved(HOME, (Motion){.turn_right = quarter});
    expect_near(right.from, HOME.from, "the eye");
    expect_near(right.at, (Vec3){4, -4, 0}, "to the right");
    const View up = moved(HOME, (Motion){.turn_up = quarter / 2});
    expect_near(up.at, (Vec3){0, -4 + 2 * (f32)M_SQRT2, 2 * (f32)M_SQRT2}, "half up");
}

Test(flight, orbits_look_at_the_middle)
{
    const f32 quarter = (f32)M_PI / 2;
    const View right = moved(HOME, (Motion){.orbit_right = quarter});
    expect_near(right.from, (Vec3){4, 0, 0}, "a quarter to the right");
    expect_near(right.at, HOME.at, "the middle");
    const View up = moved(HOME, (Motion){.orbit_up = quarter / 2});
    expect_near(up.from, (Vec3){0, -2 * (f32)M_SQRT2, 2 * (f32)M_SQRT2}, "half up");
    expect_near(up.at, HOME.at, "the middle");
}

Test(flight, an_orbit_takes_along_who_looks_aside)
{
    View view = HOME;
    view.at = (Vec3){2, 0, 0};
    const View round = moved(view, (Motion){.orbit_right = (f32)M_PI});
    expect_near(round.from, (Vec3){0, 4, 0}, "the eye");
    expect_near(round.at, (Vec3){-2, 0, 0}, "where it looks");
}

// However long one looks up, the view stays one that a camera can be set up from.
Test(flight, never_straight_up_or_down)
{
    for (int sign = -1; sign <= 1; sign += 2) {
        View turning = HOME, orbiting = HOME;
        for (int i = 0; i < 1000; i++) {
            turning = moved(turning, (Motion){.turn_up = 0.01f * (f32)sign});
            orbiting = moved(orbiting, (Motion){.orbit_up = 0.01f * (f32)sign});
            cr_assert_null(scene3d_view_fault(&turning));
            cr_assert_null(scene3d_view_fault(&orbiting));
        }
        const Vec3 sight = vec3_normalized(vec3_minus(turning.at, turning.from));
        cr_expect(sign * sight.z > 0.99f, "it comes near: %g", sight.z);
        cr_expect(sign * orbiting.from.z > 3.9f, "and so does an orbit: %g", orbiting.from.z);
    }
}
