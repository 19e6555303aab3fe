// Judge of lab 05: each function on chosen inputs, and what rays hit in whole scenes. Read next:
// judge_05.h.
#include "judge_05.h"

#include "job_work.h"
#include "message.h"

#include <math.h>
#include <string.h>

static const char *const edge_names[N_EDGES] = {"inside", "large-small", "behind", "one", "none"};

// ---- Rolling the job ----------------------------------------------------------------------------

// How much larger the outer one of two shells is: as little as float is sure to tell.
#define SHELL 0x1p-19f

// Where a sphere of MANY is, and how large. Behind the eye, or one of two around a centre: the
// inner one stands before the outer one in the array, or after it.
static Sphere many_sphere(const Scene3D *s, int i)
{
    const Vec3 eye = s->view.from;
    const int shell = i - N_BEHIND;
    if (shell < 0) {
        return (Sphere){2 * eye.x, 2 * eye.y, 2 * eye.z, 0.5f};
    }
    const Sphere first = s->spheres[N_BEHIND + shell / 2 * 2];
    const int is_outer = shell % 2 != shell / 2 % 2;
    return (Sphere){first.x, first.y, first.z, 0.375f + (is_outer ? SHELL : 0)};
}

static int roll_many(Random *random, JobScene3D *scene)
{
    enum { N_SHELLS = 24 };
    if (job_scene3d_random(scene, random, N_BEHIND + N_SHELLS, 0.25f, 0.5f, 11, 7) != 0) {
        return -1;
    }
    // So far away that a share of the distance is more than what is between two shells, and so
    // narrow that many rays meet one.
    View *view = &scene->scene.view;
    view->from = vec3_scaled(vec3_normalized(view->from), 5);
    view->angle = 25;
    job_scene3d_aim(scene);
    for (int i = 0; i < N_BEHIND + N_SHELLS; i++) {
        scene->scene.spheres[i] = many_sphere(&scene->scene, i);
    }
    return 0;
}

static int roll_scenes(Random *random, JobScene3D scenes[N_SCENES])
{
    int result = job_scene3d_random(&scenes[RANDOM], random, 100, 0.0625f, 0.25f, 96, 64);
    result |= job_scene3d_random(&scenes[SMALL], random, 60, 0.125f, 0.375f, 49, 67);
    result |= job_scene3d_named(&scenes[LARGE], random, "sphereflake:size=2", 64, 64);
    result |= roll_many(random, &scenes[MANY]);
    result |= job_scene3d_named(&scenes[TIES], random, "coincident", 64, 48);
    for (int i = 0; i < N_EDGES; i++) {
        result |= job_scene3d_named(&scenes[EDGES + i], random, edge_names[i], 48, 36);
    }
    if (result == 0) {
        job_scene3d_scale(&scenes[SMALL], 0x1p-20f, "a millionth as large");
        job_scene3d_scale(&scenes[LARGE], 0x1p40f, "a trillion times as large");
    }
    for (int k = 0; result == 0 && k < N_SCENES; k++) {
        result = job_scene3d_expect(&scenes[k]);
    }
    return result;
}

static int roll(void *pointer, Random *random)
{
    Job05 *job = pointer;
    roll_inputs_05(job, random);
    inputs_05_set_edges(job);
    inputs_05_link(job);
    roll_squares_05(random, job->squares);
    if (roll_scenes(random, job->scenes) != 0) {
        return -1;
    }
    inputs_05_add_sent(job, random);
    return 0;
}

// ---- Scenes -------------------------------------------------------------------------------------

// Are the hits of all scenes those by these rules? Scenes without an answer, behind the end of a
// program, do not count.
static int all_follow(const Job05 *job, const OracleRules3D *rules, const Sections *answers)
{
    int k = 0;
    for (; k < N_SCENES; k++) {
        const HitAnswer *found = hits_find(&job->scenes[k], k, answers);
        if (found != NULL && !hits_follow(&job->scenes[k], found, rules)) {
            break;
        }
    }
    return k == N_SCENES;
}

// The known mistake that explains the hits of all scenes, or nothing.
static Cause mistake_of_all(const Job05 *job, const Sections *answers)
{
    OracleRules3D rules = {0};
    Cause cause = hit_mistake(0, &rules);
    for (int i = 1; cause.says != NULL && !all_follow(job, &rules, answers); i++) {
        cause = hit_mistake(i, &rules);
    }
    return cause;
}

// The wrong rays of a scene.
typedef struct WrongRays {
    int n, n_lost, n_cut,
        n_other_shell;  // those that hit nothing, that name the sphere's index cut
                        // to 16 bits, or the other shell
    int n_kept;      // that kept a farther sphere which was asked before, or one as far but for a
                     // millionth
    int are_of_one;  // there is one sphere that all should hit: then that may be what is missing
    double nearest, farthest, nearest_right, farthest_right;  // t of what is to be hit
} WrongRays;

static int is_kept(const OracleHit *expected, HitAnswer found)
{
    return found.sphere != ORACLE_NO_SPHERE && found.t > expected->t &&
           (found.sphere < expected->sphere || found.t <= expected->t * (1 + 0x1p-19));
}

static void add_wrong(WrongRays *rays, const OracleHit *expected, HitAnswer found)
{
    rays->n++;
    rays->n_lost += found.sphere == ORACLE_NO_SPHERE;
    rays->n_cut += found.sphere == (expected->sphere & 0xffff);
    rays->n_other_shell += (found.sphere ^ expected->sphere) == 1;
    rays->n_kept += is_kept(expected, found);
    rays->nearest = fmin(rays->nearest, expected->t);
    rays->farthest = fmax(rays->farthest, expected->t);
}

static WrongRays list_wrong(const JobScene3D *scene, const HitAnswer *found)
{
    WrongRays rays = {.are_of_one = 1, .nearest = INFINITY, .nearest_right = INFINITY};
    u32 first = ORACLE_NO_SPHERE;
    for (int pixel = 0; pixel < scene->scene.width * scene->scene.height; pixel++) {
        const OracleHit *hit = &scene->hits[pixel];
        if (hit->is_ambiguous || hit->sphere == ORACLE_NO_SPHERE) {
            continue;
        }
        if (hit_is_right(hit, found[pixel])) {
            rays.nearest_right = fmin(rays.nearest_right, hit->t);
            rays.farthest_right = fmax(rays.farthest_right, hit->t);
        } else {
            first = rays.n == 0 ? hit->sphere : first;
            rays.are_of_one &= hit->sphere == first;
            add_wrong(&rays, hit, found[pixel]);
        }
    }
    return rays;
}

#define SO_SMALL "as if differences so small did not count: nearer is nearer"

// What wrong hits look like in a scene that is special by its size: one of usual size is right.
static Cause looks_at_size(const JobScene3D *scene, int k, const HitAnswer *found)
{
    const WrongRays rays = list_wrong(scene, found);
    const int n = rays.n;
    const char *says = NULL;
    if (n == 0 || n != hits_count_wrong(scene, found)) {
        return (Cause){0};
    }
    if (k == MANY && rays.n_cut == n) {
        says = "the index was cut to 16 bits";
    } else if (!rays.are_of_one) {
        says = k == MANY && rays.n_other_shell == n ? SO_SMALL
               : k == SMALL && rays.n_lost == n && rays.farthest <= rays.nearest_right
                   ? "as if hits so close to the eye did not count"
               : k == SMALL && rays.n_kept == n ? SO_SMALL
               : k == LARGE && rays.n_lost == n && rays.nearest >= rays.farthest_right
                   ? "as if hits so far away did not count"
                   : NULL;
    }
    return (Cause){.says = says};
}

static int is_special_by_size(int k)
{
    return k == SMALL || k == LARGE || k == MANY;
}

static Verdict judge_hits(const void *job, int k, const Sections *answers)
{
    const JobScene3D *scene = &((const Job05 *)job)->scenes[k];
    const HitAnswer *found = hits_find(scene, k, answers);
    if (found == NULL) {
        return verdict_missing;
    }
    if (hits_count_wrong(scene, found) == 0) {
        return verdict_passed;
    }
    // In one scene a few rays may look like more than one mistake.
    const Cause of_all = mistake_of_all(job, answers);
    if (of_all.says == NULL && !is_special_by_size(k)) {
        return verdict_of(hits_judge(scene, found));
    }
    return verdict_of(
        hits_judge_as(scene, found, of_all.says != NULL ? of_all : looks_at_size(scene, k, found)));
}

// How many spheres are asked where the one before has the same place and radius, or where the
// centre is behind the ray's origin, is passed over.
static int is_same_as_before(const Scene3D *scene, int i)
{
    return i > 0 && memcmp(&scene->spheres[i], &scene->spheres[i - 1], sizeof(Sphere)) == 0;
}

static u32 count_different(const Scene3D *scene)
{
    u32 n = 0;
    for (int i = 0; i < scene->n_spheres; i++) {
        n += !is_same_as_before(scene, i);
    }
    return n;
}

static u32 count_ahead(const JobScene3D *scene, int pixel)
{
    const Scene3D *s = &scene->scene;
    const OracleRay ray = job_scene3d_ray(scene, pixel);
    u32 n = 0;
    for (int i = 0; i < s->n_spheres; i++) {
        const OracleVector centre = {s->spheres[i].x, s->spheres[i].y, s->spheres[i].z};
        n += vector_dot(vector_minus(centre, ray.origin), ray.direction) > 0;
    }
    return n;
}

// What may be wrong with the number of tests, and what each pixel's is then.
typedef enum WorkMistake {
    WORK_NONE,
    WORK_TWICE,
    WORK_DIFFERENT,
    WORK_AHEAD,
    WORK_MORE,
    WORK_FEWER,
    N_WORK_MISTAKES
} WorkMistake;

static int work_is_of(WorkMistake mistake, const JobScene3D *scene, int pixel, u32 found)
{
    const u32 n = (u32)scene->scene.n_spheres;
    switch (mistake) {
    case WORK_NONE:
        return found == 0;
    case WORK_TWICE:
        return found == 2 * n;
    case WORK_DIFFERENT:
        return found == count_different(&scene->scene);
    case WORK_AHEAD:
        return found == count_ahead(scene, pixel);
    case WORK_MORE:
        return found >= n;
    default:
        return found <= n;
    }
}

static int explains_work(WorkMistake mistake, const JobScene3D *scene, const Work *work)
{
    const int n_pixels = scene->scene.width * scene->scene.height;
    int pixel = 0;
    while (pixel < n_pixels && work_is_of(mistake, scene, pixel, work[pixel].n_tests)) {
        pixel++;
    }
    return pixel == n_pixels;
}

// Why the numbers of tests are wrong, where one mistake explains those of all pixels; or NULL.
static const char *work_looks(const JobScene3D *scene, int k, const Work *work,
                              const Sections *answers)
{
    int mistake = 0;
    while (mistake < N_WORK_MISTAKES && !explains_work((WorkMistake)mistake, scene, work)) {
        mistake++;
    }
    const HitAnswer *hits = hits_find(scene, k, answers);
    const int is_right = hits != NULL && hits_count_wrong(scene, hits) == 0;
    const char *const says[N_WORK_MISTAKES] = {
        is_right ? "the hits are right, but their calls were not counted in the `work` that was "
                   "handed in"
                 : "no sphere was asked, or not by intersect_sphere with the `work` that was "
                   "handed in",
        "each sphere was asked twice",
        "spheres like the one before were passed over: every sphere is asked",
        "spheres whose centre is behind the eye were passed over: the eye may be inside, and every "
        "sphere is asked",
        "some spheres were asked more than once, or one behind the last: a distance that is needed "
        "twice can be kept",
        "some spheres were not asked"};
    return mistake < N_WORK_MISTAKES ? says[mistake] : NULL;
}

// Every pixel asks every sphere, once.
static Verdict judge_work(const void *job, int k, const Sections *answers)
{
    const JobScene3D *scene = &((const Job05 *)job)->scenes[k];
    const int width = scene->scene.width, n_pixels = width * scene->scene.height;
    const Work *found = job_work_find(&scene->picture, k, answers);
    if (found == NULL) {
        return verdict_missing;
    }
    int pixel = 0;
    while (pixel < n_pixels && found[pixel].n_tests == (u32)scene->scene.n_spheres) {
        pixel++;
    }
    if (pixel == n_pixels) {
        return verdict_passed;
    }
    const u32 n_tests = found[pixel].n_tests;
    char *wrong = message_new("%s: the ray of pixel (%d, %d): intersect_sphere was called %u "
                              "times, but the scene has %d spheres",
                              scene->picture.title, pixel % width, pixel / width, n_tests,
                              scene->scene.n_spheres);
    return verdict_of(diagnosis_of(wrong, (Cause){.says = work_looks(scene, k, found, answers)}));
}

// ---- The judge ----------------------------------------------------------------------------------

static const JudgeCheck checks[] = {
    {"root-nearer", "Where the ray enters, or no hit", "nearest_root", .function = &nearest_root_05,
     .range = RANGE(0, N_ROOTS)},
    {"root-inside", "Where it leaves, from inside and for negative radii", "nearest_root",
     .function = &nearest_root_05, .range = RANGE(1, N_ROOTS)},
    {"root-t_min", "Only beyond t_min", "nearest_root", .function = &nearest_root_05,
     .range = RANGE(2, N_ROOTS)},

    {"textbook-outside", "Spheres before the eye, and misses", "intersect_textbook", "nearest_root",
     .function = &textbook_05, .range = RANGE(0, N_SPHERES), .alone = spheres_alone_05,
     .alone_cause = spheres_cause_05},
    {"textbook-inside", "Spheres around the eye and behind it", "intersect_textbook",
     "nearest_root", .function = &textbook_05, .range = RANGE(1, N_SPHERES),
     .alone = spheres_alone_05, .alone_cause = spheres_cause_05},

    {"sphere-near", "Spheres before the eye, and misses", "intersect_sphere", "nearest_root",
     .function = &projection_05, .range = RANGE(0, N_SPHERES), .alone = spheres_alone_05,
     .alone_cause = spheres_cause_05},
    {"sphere-inside", "Spheres around the eye and behind it", "intersect_sphere", "nearest_root",
     .function = &projection_05, .range = RANGE(1, N_SPHERES), .alone = spheres_alone_05,
     .alone_cause = spheres_cause_05},
    {"sphere-far-small", "Small spheres far away", "intersect_sphere", "nearest_root",
     .function = &projection_05, .range = RANGE(2, N_SPHERES), .alone = spheres_alone_05,
     .alone_cause = spheres_cause_05},

    {"hit-nearest", "Many spheres, at any distance", "nearest_hit", "intersect_sphere nearest_root",
     .scene = judge_hits, .range = {RANDOM, TIES}, .alone_scene = square_hits_05,
     .alone_cause = squares_cause_05},
    {"hit-ties", "Of equal distances the lower index wins", "nearest_hit",
     "intersect_sphere nearest_root", .scene = judge_hits, .range = {TIES, 1},
     .alone_scene = square_hits_05, .alone_cause = squares_cause_05},
    {"hit-edges", "Inside, behind, large and small, one, none", "nearest_hit",
     "intersect_sphere nearest_root", .scene = judge_hits, .range = {EDGES, N_EDGES},
     .alone_scene = square_hits_05, .alone_cause = squares_cause_05},
    {"hit-work", "Every sphere is asked once", "nearest_hit", .scene = judge_work,
     .range = {SMALL, N_WORK, WORK_STEP}, .alone_scene = square_work_05},

    {"normal-unit", "From the centre to the point, a unit vector", "surface_normal",
     .function = &normal_05, .range = RANGE(0, N_NORMALS)},
    {"normal-inside", "Seen from inside, towards the eye", "surface_normal", .function = &normal_05,
     .range = RANGE(1, N_NORMALS)},

    {"shade-lambert", "kd x cosine x colours, one light", "shade", .function = &shade_05,
     .range = RANGE(0, N_SHADES)},
    {"shade-behind", "A light behind the surface adds nothing", "shade", .function = &shade_05,
     .range = RANGE(1, N_SHADES)},
    {"shade-lights", "All lights, and no more", "shade", .function = &shade_05,
     .range = RANGE(2, N_SHADES)},
    {"shade-picture", "Whole pictures", "shade",
     "nearest_hit intersect_sphere nearest_root surface_normal", .scene = judge_picture,
     .range = {0, N_SCENES}, .alone = pixel_shades_05},
};

static const JobPart parts[] = {
    INPUTS("roots", "nearest_root", Job05, roots),
    INPUTS("textbook", "intersect_textbook", Job05, textbook,
           .is_apart = 1),  // alone with other t_min: write_alone_05()
    INPUTS("projection", "intersect_sphere", Job05, projection, .is_apart = 1),
    INPUTS("normals", "surface_normal", Job05, normals),
    INPUTS("shades", "shade", Job05, shades),
    DATA("lights", NULL, Job05, lights),  // alone with those of the scenes
};

const Judge judge_05 = {
    .lab = "05-spheres",
    .checks = checks,
    .n_checks = COUNT(checks),
    .job_bytes = sizeof(Job05),
    .roll = roll,
    .parts = parts,
    .n_parts = COUNT(parts),
    .scenes = SCENES(job_scene3d_kind, Job05, scenes),
    .scene_steps = {{"hits", "in nearest_hit", "nearest_hit"},
                    {"picture", "in render_spheres", NULL}},
    .write_alone = write_alone_05,
};
