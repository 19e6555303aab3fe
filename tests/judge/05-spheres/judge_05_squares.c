// Lab 05: nearest_hit alone. Beside the stub of intersect_sphere spheres are squares, which
// rays along z meet: all in steps of 1/16 or 1/4, so that hits are foreseen to the bit.
#include "judge_05.h"

#include "work.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

// The probe's rays: from (x, y, 0) along z. All that the stub asks of one has the same name on
// the device.
typedef struct Ray {
    Vec3 origin, direction;
    float t_min;
} Ray;

static Ray grid_ray(int x, int y)
{
    return (Ray){{(float)x, (float)y, 0}, {0, 0, 1}, SQUARES_T_MIN};
}

// What stands in the hole of intersect_sphere.
static float stub_square(Sphere sphere, Ray ray)
{
#include "05-spheres/intersect_sphere.cl"
}

// Squares of a scene: how many, how large, at how many distances, `step` apart, in which picture.
// Every nth has a negative radius: nobody hits it. Every mth is the same as the one before.
typedef struct SquarePlan {
    int n, max_radius, n_distances;
    float step;
    int width, height, every_negative;
    float nearest;   // added to each distance
    int every_same;  // m
} SquarePlan;

static const SquarePlan plans[N_SCENES] = {
    [RANDOM] = {60, 6, 4000, 0.25f, 48, 32, 0, 0},
    [SMALL] = {100, 5, 900, 0x1p-24f, 49, 37, 6, -SQUARES_T_MIN},  // hits close to 0
    [LARGE] = {MAX_SQUARES, 3, 300, 0x1p40f, 64, 40, 0},
    [MANY] = {60, 5, 40, 0x1p-18f, 16, 12, 0, 16},  // as little apart as float can tell
    [TIES] = {90, 8, 3, 1, 64, 48, 7, 0, 5},
    [EDGES] = {1, 6, 5, 1, 16, 16, 0},
    [EDGES + 1] = {0, 1, 1, 1, 16, 16, 0},
    [EDGES + 2] = {12, 6, 9, 1, 24, 16, 1},           // nothing is hit, though much is asked
    [EDGES + 3] = {30, 8, 9, 65536, 24, 16, 0},       // far away
    [EDGES + 4] = {30, 30, 900, 0.0625f, 24, 24, 0},  // large: everything is hit many times
};

static void roll_squares(Random *random, const SquarePlan *plan, SquareScene *scene)
{
    scene->n = plan->n;
    scene->n_behind = plan == &plans[MANY] ? N_BEHIND : 0;
    scene->width = plan->width, scene->height = plan->height;
    for (int i = 0; i < plan->n; i++) {
        const int is_negative = plan->every_negative > 0 && i % plan->every_negative == 0;
        const float x = random_grid(random, 0, plan->width);
        const float y = random_grid(random, 0, plan->height);
        const float z =
            plan->nearest + plan->step * (float)random_integer(random, 1, plan->n_distances);
        const float radius = random_grid(random, 1, plan->max_radius);
        const int is_same = plan->every_same > 0 && i % plan->every_same == plan->every_same - 1;
        scene->squares[i] =
            is_same ? scene->squares[i - 1] : (Sphere){x, y, z, is_negative ? -radius : radius};
    }
    scene->squares[plan->n] = (Sphere){0, 0, 0.03125f, 1000};
}

void roll_squares_05(Random *random, SquareScene scenes[N_SCENES])
{
    for (int k = 0; k < N_SCENES; k++) {
        roll_squares(random, &plans[k], &scenes[k]);
    }
}

static int write_squares(const SquareScene *scene, int k, FILE *file)
{
    const size_t n = (size_t)scene->n + 1;  // with the one that must not be asked
    const SceneJob3D size = {
        .n_spheres = scene->n_behind + scene->n, .width = scene->width, .height = scene->height};
    Sphere *squares = malloc(((size_t)scene->n_behind + n) * sizeof *squares);
    if (squares == NULL) {
        return -1;
    }
    for (int i = 0; i < scene->n_behind; i++) {
        squares[i] = (Sphere){.radius = -1};
    }
    memcpy(squares + scene->n_behind, scene->squares, n * sizeof *squares);
    const int result = job_section_write(file, k, NULL, &size, sizeof size) |
                       job_section_write(file, k, "spheres", squares,
                                         ((size_t)scene->n_behind + n) * sizeof *squares);
    free(squares);
    return result;
}

int squares_05_write(const SquareScene scenes[N_SCENES], FILE *file)
{
    int result = 0;
    for (int k = 0; k < N_SCENES; k++) {
        result |= write_squares(&scenes[k], k, file);
    }
    return result;
}

// Does a hit take the place of the one so far?
static int takes(float t, HitAnswer so_far, const OracleRules3D *rules)
{
    const int is_first = so_far.sphere == ORACLE_NO_SPHERE;
    return is_first               ? !isinf(t)
           : isinf(t)             ? 0
           : rules->first_wins    ? 0
           : rules->last_wins     ? 1
           : rules->farthest_wins ? t > so_far.t
                                  : t < so_far.t || (rules->later_wins_ties && t == so_far.t);
}

static int hits_square(const SquareScene *scene, int x, int y, const OracleRules3D *rules,
                       HitAnswer found)
{
    HitAnswer hit = {INFINITY, ORACLE_NO_SPHERE};
    const int n = scene->n - rules->skip_last + rules->one_sphere_more;
    for (int i = rules->skip_first && scene->n_behind == 0; i < n; i++) {
        const float t = stub_square(scene->squares[i], grid_ray(x, y));
        if (takes(t, hit, rules)) {
            hit = (HitAnswer){t, (u32)(scene->n_behind + i)};
        }
    }
    return found.sphere == hit.sphere && found.t == hit.t;
}

// Are all hits of scene K those by these rules?
static int hits_squares(const Job05 *job, int k, const OracleRules3D *rules,
                        const Sections *answers)
{
    const SquareScene *scene = &job->squares[k];
    const int n_pixels = scene->width * scene->height;
    const HitAnswer *found = job_section_find(answers, "hits", k, (size_t)n_pixels * sizeof *found);
    int i = 0;
    while (found != NULL && i < n_pixels &&
           hits_square(scene, i % scene->width, i / scene->width, rules, found[i])) {
        i++;
    }
    return i == n_pixels;
}

int square_hits_05(const void *job, int k, const Sections *answers)
{
    static const OracleRules3D right = {0};
    return hits_squares(job, k, &right, answers);
}

// Does a mistake explain the hits of all scenes? Of those of one sphere it makes no difference.
Cause squares_cause_05(const void *job, const JudgeCheck *check, const Sections *answers)
{
    OracleRules3D rules = {0};
    Cause cause = hit_mistake(0, &rules);
    (void)check;
    for (int i = 1; cause.says != NULL; i++) {
        int k = 0;
        while (k < N_SCENES && hits_squares(job, k, &rules, answers)) {
            k++;
        }
        if (k == N_SCENES) {
            break;
        }
        cause = hit_mistake(i, &rules);
    }
    return cause;
}

int square_work_05(const void *job, int k, const Sections *answers)
{
    const SquareScene *scene = &((const Job05 *)job)->squares[k];
    const int n_pixels = scene->width * scene->height;
    const Work *found = job_section_find(answers, "work", k, (size_t)n_pixels * sizeof *found);
    int i = 0;
    while (found != NULL && i < n_pixels && found[i].n_tests == (u32)(scene->n_behind + scene->n)) {
        i++;
    }
    return i == n_pixels;
}
