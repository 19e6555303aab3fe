// The sphereflake, "balls" of Eric Haines' Standard Procedural Databases (1987): a ball that bears
// nine balls of a third of its size, each of which bears nine, and so on.
//
// The floor of the original, a polygon, is left out. Where a ball points straight down, rounding
// decides how the original turns its children; here it is a half turn, see turned_towards().
// Computed in double with the four operations and sqrt(), whose results differ between compilers by
// 1e-16 at most; rounded_coordinate() keeps that out of the scene.
// Read next: scene3d_lattice.c.
#include "scene3d.h"

#include <math.h>

#define N_CHILDREN 9
#define CHILD_SIZE (1.0 / 3)

typedef struct Direction {
    double x, y, z;
} Direction;

// A ball while it is placed. Its children stand around `pole`, the direction away from its parent.
typedef struct Ball {
    double x, y, z;
    double radius;
    Direction pole;  // unit vector
} Ball;

// The nine unit vectors from a ball to its children, the pole being +z: three times one child up at
// a third of the horizontal and two on the equator, 60 degrees apart.
static void child_directions(Direction directions[N_CHILDREN])
{
    const double cos_15 = (sqrt(6) + sqrt(2)) / 4;
    const double sin_15 = (sqrt(6) - sqrt(2)) / 4;
    const Direction trio[3] = {
        {sqrt(1.0 / 6), sqrt(1.0 / 6), sqrt(2.0 / 3)},  // at 45 degrees around the pole
        {cos_15, sin_15, 0},                            // at 15 degrees
        {sin_15, cos_15, 0},                            // at 75 degrees
    };
    // Each trio is the first one, turned by 0, 120 and 240 degrees around the pole.
    const double cosines[3] = {1, -0.5, -0.5};
    const double sines[3] = {0, sqrt(0.75), -sqrt(0.75)};
    for (int i = 0; i < N_CHILDREN; i++) {
        const Direction *from = &trio[i % 3];
        double cosine = cosines[i / 3];
        double sine = sines[i / 3];
        directions[i].x = from->x * cosine - from->y * sine;
        directions[i].y = from->x * sine + from->y * cosine;
        directions[i].z = from->z;
    }
}

// v, turned the way that leads +z straight to the pole.
static Direction turned_towards(Direction pole, Direction v)
{
    // Straight down there are many straight ways; the original means a half turn around y. Poles
    // that should point down miss it by rounding, by 1e-15; all others, in a flake of the largest
    // size, by more than 1e-9.
    const double down = -1 + 1e-12;
    if (pole.z < down) {
        return (Direction){-v.x, v.y, -v.z};
    }
    // Rodrigues' formula: the axis is z x pole, of length sin(angle); the cosine is pole.z.
    const double axis_x = -pole.y;
    const double axis_y = pole.x;
    const double along = (axis_x * v.x + axis_y * v.y) / (1 + pole.z);
    return (Direction){
        v.x * pole.z + axis_y * v.z + axis_x * along,
        v.y * pole.z - axis_x * v.z + axis_y * along,
        v.z * pole.z + axis_x * v.y - axis_y * v.x,
    };
}

// Rounded to steps of 2^-30, a 64th of float's own below 1: what should be 0 is 0, not 1e-17, and
// up to size 6 the scene is the same whether a compiler contracts a * b + c to one operation or
// not.
static f32 rounded_coordinate(double coordinate)
{
    const double steps_per_unit = 1 << 30;
    return (f32)((double)llround(coordinate * steps_per_unit) / steps_per_unit);
}

// Add the ball, then its children, each with all its own.
static void ball_add(Ball ball, int size, const Direction directions[N_CHILDREN], Scene3D *scene)
{
    scene->spheres[scene->n_spheres++] =
        (Sphere){rounded_coordinate(ball.x), rounded_coordinate(ball.y), rounded_coordinate(ball.z),
                 (f32)ball.radius};
    if (size == 0) {
        return;
    }
    const double distance = ball.radius * (1 + CHILD_SIZE);
    for (int i = 0; i < N_CHILDREN; i++) {
        Direction pole = turned_towards(ball.pole, directions[i]);
        Ball child = {ball.x + distance * pole.x, ball.y + distance * pole.y,
                      ball.z + distance * pole.z, ball.radius * CHILD_SIZE, pole};
        ball_add(child, size - 1, directions, scene);
    }
}

int scene3d_sphereflake(int size, Scene3D *scene)
{
    const Vec3 lights[] = {{4, 3, 2}, {1, -4, 4}, {-3, 1, 5}};
    const int n_lights = sizeof lights / sizeof lights[0];
    int n_spheres = 1;
    for (int i = 0; i < size; i++) {
        n_spheres = n_spheres * N_CHILDREN + 1;
    }
    if (scene3d_create(n_spheres, 1, n_lights, (Vec3){2.1f, 1.3f, 1.7f}, scene) != 0) {
        return -1;
    }
    scene->background = (Vec3){0.078f, 0.361f, 0.753f};
    scene->view.hither = 0.01f;
    for (int i = 0; i < n_lights; i++) {
        scene->lights[i] = (Light){lights[i], scene3d_light_color(n_lights)};
    }
    scene->materials[0] = (Material){{1, 0.9f, 0.7f}, 0.5f, 0.5f, 3.0827f, 0, 1};

    Direction directions[N_CHILDREN];
    child_directions(directions);
    scene->n_spheres = 0;
    ball_add((Ball){0, 0, 0, 0.5, {0, 0, 1}}, size, directions, scene);
    return 0;
}
