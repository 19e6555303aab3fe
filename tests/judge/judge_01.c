// Judge of lab 01: overlaps_N_Nearer on chosen inputs, and pictures of the naive renderer.
#include "judge.h"

#include "alone_picture.h"
#include "job_scene.h"
#include "jobs.h"
#include "message.h"
#include "oracle2d.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum {
    OVERLAPS_INSIDE,
    OVERLAPS_BOUNDARY,
    OVERLAPS_NEARER,
    OWN_PIXEL_PICTURE,
    OWN_PIXEL_PADDING,
    RENDERER_RANDOM,
    RENDERER_ORDER,
    RENDERER_EDGES,
};

static const Check checks[] = {
    [OVERLAPS_INSIDE] = {"overlaps-inside", "Pixels clearly inside and outside a circle",
                         "overlaps_N_Nearer", 15},
    [OVERLAPS_BOUNDARY] = {"overlaps-boundary", "Pixels exactly on the boundary",
                           "overlaps_N_Nearer", 10},
    [OVERLAPS_NEARER] = {"overlaps-nearer", "Nearer, equally far and farther than minDepth",
                         "overlaps_N_Nearer", 15},
    [OWN_PIXEL_PICTURE] = {"own_pixel-picture", "Every work-item draws its own pixel", "own_pixel",
                           10, "*"},
    [OWN_PIXEL_PADDING] = {"own_pixel-padding", "Nothing is written outside the picture",
                           "own_pixel", 10},
    [RENDERER_RANDOM] = {"renderer-random", "Random scenes", "implicit2DRenderer", 20, "*"},
    [RENDERER_ORDER] = {"renderer-order", "Of equal depths the lower index wins",
                        "implicit2DRenderer", 10, "*"},
    [RENDERER_EDGES] = {"renderer-edges", "No circles, far outside, touching, huge, tiny",
                        "implicit2DRenderer", 10, "*"},
};

// The scenes, in the order of the job; each check looks at a range of them.
enum {
    WIDE = 0,    // 317x211
    HIGH = 1,    // 48x64
    RANDOM = 2,  // two more
    ORDER = 4,
    EDGES = 5,
    N_EDGES = 6,
    N_SCENES = EDGES + N_EDGES,
};
static const char *const edge_names[N_EDGES] = {"none",     "outside", "borders",
                                                "touching", "huge",    "tiny"};

// How many inputs each of the three function checks tries, one range after the other.
enum { N_INSIDE = 3000, N_BOUNDARY = 1000, N_NEARER = 1000 };
enum { N_OVERLAPS = N_INSIDE + N_BOUNDARY + N_NEARER };

typedef struct Job {
    OverlapJob overlaps[N_OVERLAPS];
    JobScene scenes[N_SCENES];
    JobPicture *pictures[N_SCENES];  // the scenes'
} Job;

// A pixel within two radii of a random circle that is nearer than minDepth.
static OverlapJob draw_inside(Random *random)
{
    OverlapJob job = {.minDepth = 0.75f};
    job.circle.x = random_grid(random, -10, 300);
    job.circle.y = random_grid(random, -10, 300);
    job.circle.radius = random_grid(random, 1, 60);
    job.circle.depth = 0.25f;
    job.x = (int)lrintf(job.circle.x +
                        (float)random_integer(random, -1000, 1000) / 500 * job.circle.radius);
    job.y = (int)lrintf(job.circle.y +
                        (float)random_integer(random, -1000, 1000) / 500 * job.circle.radius);
    return job;
}

// A pixel exactly on the boundary (a Pythagorean triple from the centre), or one step beside it.
static OverlapJob draw_boundary(Random *random)
{
    static const int triples[][3] = {{3, 4, 5}, {5, 12, 13},  {8, 15, 17}, {7, 24, 25},
                                     {0, 6, 6}, {20, 21, 29}, {0, 1, 1},   {9, 40, 41}};
    const int *triple = triples[random_integer(random, 0, 7)];
    const int swap = (int)random_integer(random, 0, 1);
    const int sign_x = random_integer(random, 0, 1) ? 1 : -1;
    const int sign_y = random_integer(random, 0, 1) ? 1 : -1;
    OverlapJob job = {.minDepth = INFINITY};
    job.circle.x = (float)random_integer(random, 0, 200);
    job.circle.y = (float)random_integer(random, 0, 200);
    job.circle.radius = (float)triple[2];
    job.circle.depth = 0.5f;
    const int step = random_integer(random, 0, 3) == 0 ? (int)random_integer(random, -1, 1) : 0;
    job.x = (int)job.circle.x + sign_x * triple[swap] + step;
    job.y = (int)job.circle.y + sign_y * triple[1 - swap];
    return job;
}

// The centre of a circle, with a depth below, at or above minDepth; negative ones and infinity too.
static OverlapJob draw_nearer(Random *random)
{
    OverlapJob job = {0};
    job.x = (int)random_integer(random, 0, 200);
    job.y = (int)random_integer(random, 0, 200);
    job.circle.x = (float)job.x;
    job.circle.y = (float)job.y;
    job.circle.radius = random_grid(random, 1, 20);
    job.circle.depth = (float)random_integer(random, -8, 8) / 4;
    const int kind = (int)random_integer(random, 0, 3);
    job.minDepth = kind == 0   ? INFINITY
                   : kind == 1 ? job.circle.depth
                               : (float)random_integer(random, -8, 8) / 4;
    return job;
}

static void draw_overlaps(Random *random, OverlapJob jobs[N_OVERLAPS])
{
    for (int i = 0; i < N_OVERLAPS; i++) {
        jobs[i] = i < N_INSIDE                ? draw_inside(random)
                  : i < N_INSIDE + N_BOUNDARY ? draw_boundary(random)
                                              : draw_nearer(random);
    }
}

static int draw_scenes(Random *random, JobScene scenes[N_SCENES])
{
    int result = job_scene_random(&scenes[WIDE], random, 120, 24, 317, 211);
    result |= job_scene_random(&scenes[HIGH], random, 30, 12, 48, 64);
    result |= job_scene_random(&scenes[RANDOM], random, 200, 16, 128, 96);
    result |= job_scene_random(&scenes[RANDOM + 1], random, 7, 40, 96, 100);
    job_scene_spread_depths(&scenes[RANDOM + 1]);
    result |= job_scene_named(&scenes[ORDER], "equal-depths", 96, 64);
    for (int i = 0; i < N_EDGES; i++) {
        result |= job_scene_named(&scenes[EDGES + i], edge_names[i], 64, 48);
    }
    for (int k = 0; result == 0 && k < N_SCENES; k++) {
        result = job_scene_expect(&scenes[k]);
    }
    return result;
}

static void job_free(void *pointer)
{
    Job *job = pointer;
    for (int k = 0; k < N_SCENES; k++) {
        job_scene_free(&job->scenes[k]);
    }
    free(job);
}

static void *job_new(uint64_t seed, FILE *file)
{
    Random random = {seed};
    Job *job = calloc(1, sizeof *job);
    if (job == NULL) {
        fprintf(stderr, "grade: no memory for a job\n");
        return NULL;
    }
    job_scenes_list(job->scenes, N_SCENES, job->pictures);
    draw_overlaps(&random, job->overlaps);
    int result = draw_scenes(&random, job->scenes);
    result |= section_write(file, "overlaps", job->overlaps, sizeof job->overlaps);
    for (int k = 0; result == 0 && k < N_SCENES; k++) {
        result = job_scene_write(&job->scenes[k], k, file);
    }
    if (result != 0) {
        job_free(job);
        return NULL;
    }
    return job;
}

// What a wrong answer of overlaps_N_Nearer suggests, "" when nothing.
static const char *explain_overlap(OverlapJob input, int found)
{
    const double dx = input.x - (double)input.circle.x, dy = input.y - (double)input.circle.y;
    const double radius = input.circle.radius;
    const int on_boundary = dx * dx + dy * dy == radius * radius;
    if (found && input.circle.depth == input.minDepth) {
        return "; nearer is strict: a circle at equal depth does not take the pixel";
    }
    if (found && input.circle.depth > input.minDepth) {
        return "; the circle is farther than what the pixel has seen";
    }
    if (!found && on_boundary) {
        return "; strict where it should not be: the boundary belongs to the circle";
    }
    if (found && oracle2d_covers(input.circle, input.x, input.y) == 0 && fabs(dx) <= radius &&
        fabs(dy) <= radius) {
        return "; the pixel is in the circle's bounding square but not in the circle";
    }
    return "";
}

// Are all answers of a range those of a sample point that is `offset` away from the pixel's?
static int is_shifted(const Job *job, int first, int n, const i32 *found, double offset)
{
    for (int i = first; i < first + n; i++) {
        const OverlapJob in = job->overlaps[i];
        const int shifted = oracle2d_covers(in.circle, in.x + offset, in.y + offset) &&
                            in.circle.depth < in.minDepth;
        if ((found[i] != 0) != shifted) {
            return 0;
        }
    }
    return 1;
}

static Verdict judge_overlaps(const Job *job, int first, int n, const Sections *answers)
{
    const i32 *found = sections_find(answers, "overlaps", N_OVERLAPS * sizeof *found);
    if (found == NULL) {
        return verdict_missing;
    }
    int n_wrong = 0, first_wrong = 0;
    const char *why = NULL;
    for (int i = first + n - 1; i >= first; i--) {
        const OverlapJob input = job->overlaps[i];
        const int expected =
            oracle2d_covers(input.circle, input.x, input.y) && input.circle.depth < input.minDepth;
        if ((found[i] != 0) != expected) {
            // A cause is named only when it explains every wrong answer.
            const char *cause = explain_overlap(input, found[i] != 0);
            why = n_wrong++ == 0 || why == cause ? cause : "";
            first_wrong = i;
        }
    }
    if (n_wrong == 0) {
        return verdict_of(NULL);
    }
    if (is_shifted(job, first, n, found, 0.5) || is_shifted(job, first, n, found, -0.5)) {
        why = "; shifted by half a pixel: the sample point is the integer coordinate";
    }
    const OverlapJob input = job->overlaps[first_wrong];
    const int answer = found[first_wrong] != 0;
    return verdict_of(message_new(
        "pixel (%d, %d), circle at (%g, %g) radius %g depth %g, minDepth %g: found %d, expected "
        "%d (%d of %d inputs are wrong)%s",
        input.x, input.y, (double)input.circle.x, (double)input.circle.y,
        (double)input.circle.radius, (double)input.circle.depth, (double)input.minDepth, answer,
        !answer, n_wrong, n, why));
}

static Verdict judge(const void *pointer, int check, const Sections *answers)
{
    const Job *job = pointer;
    switch (check) {
    case OVERLAPS_INSIDE:
        return judge_overlaps(job, 0, N_INSIDE, answers);
    case OVERLAPS_BOUNDARY:
        return judge_overlaps(job, N_INSIDE, N_BOUNDARY, answers);
    case OVERLAPS_NEARER:
        return judge_overlaps(job, N_INSIDE + N_BOUNDARY, N_NEARER, answers);
    case OWN_PIXEL_PICTURE:
        return job_pictures_judge(job->pictures, WIDE, 2, answers);
    case OWN_PIXEL_PADDING:
        return job_pictures_judge_padding(job->pictures, N_SCENES, answers);
    case RENDERER_RANDOM:
        return job_pictures_judge(job->pictures, RANDOM, 2, answers);
    case RENDERER_ORDER:
        return job_pictures_judge(job->pictures, ORDER, 1, answers);
    default:
        return job_pictures_judge(job->pictures, EDGES, N_EDGES, answers);
    }
}

// ---- Alone --------------------------------------------------------------------------------------

// The hole of overlaps_N_Nearer while another task is tried.
static int stand_in_overlaps(int x, int y, Circle circle, float minDepth)
{
#include "01-naive-2d/overlaps_N_Nearer.cl"
}

// What implicit2DRenderer makes of that. As ColorAt of alone_picture.h has it.
static void nearest_color(const void *pointer, int x, int y, float color[4])
{
    const Scene2D *scene = pointer;
    float minDepth = INFINITY;
    for (int i = 0; i < scene->n_circles; i++) {
        const Circle circle = scene->circles[i];
        if (stand_in_overlaps(x, y, circle, minDepth)) {
            minDepth = circle.depth;
            memcpy(color, &circle.r, 4 * sizeof *color);
        }
    }
}

// The colour by the stand-in of the loop.
static void own_color(const void *pointer, int x, int y, float color[4])
{
    const Scene2D *scene = pointer;
    color[0] = (float)x;
    color[1] = (float)y;
    color[2] = (float)scene->n_circles;
    color[3] = 1;
}

// Which of the job's scenes a task is tried with: `first` and on, as scenes 0 and on.
static void alone_scenes(const char *task, int *first, int *n)
{
    *first = strcmp(task, "own_pixel") == 0 ? WIDE : RANDOM;
    *n = strcmp(task, "own_pixel") == 0 ? RANDOM - WIDE : N_SCENES - RANDOM;
}

static int write_alone(const void *pointer, const char *task, FILE *file)
{
    const Job *job = pointer;
    if (strcmp(task, "overlaps_N_Nearer") == 0) {
        return section_write(file, "overlaps", job->overlaps, sizeof job->overlaps);
    }
    int first, n, result = 0;
    alone_scenes(task, &first, &n);
    for (int k = 0; result == 0 && k < n; k++) {
        result = job_scene_write(&job->scenes[first + k], k, file);
    }
    return result;
}

// Are the pictures of the job's scenes first to first + n - 1 drawn so? Scene `base` is the first
// that the task is tried with.
static int are_drawn(const Job *job, int base, int first, int n, ColorAt *color_at,
                     const Sections *answers)
{
    int are_right = 1;
    for (int k = first; are_right && k < first + n; k++) {
        const Scene2D *scene = &job->scenes[k].scene;
        are_right = alone_picture_is_right(answers, k - base, scene->width, scene->height, 0,
                                           color_at, scene);
    }
    return are_right;
}

static int passes_alone(const void *pointer, int check, const Sections *answers)
{
    const Job *job = pointer;
    switch (check) {
    case OWN_PIXEL_PICTURE:
        return are_drawn(job, WIDE, WIDE, 2, own_color, answers);
    case OWN_PIXEL_PADDING:
        return alone_picture_keeps_inside(answers, 0, job->scenes[WIDE].scene.width,
                                          job->scenes[WIDE].scene.height) &&
               alone_picture_keeps_inside(answers, 1, job->scenes[HIGH].scene.width,
                                          job->scenes[HIGH].scene.height);
    case RENDERER_RANDOM:
        return are_drawn(job, RANDOM, RANDOM, 2, nearest_color, answers);
    case RENDERER_ORDER:
        return are_drawn(job, RANDOM, ORDER, 1, nearest_color, answers);
    case RENDERER_EDGES:
        return are_drawn(job, RANDOM, EDGES, N_EDGES, nearest_color, answers);
    default:
        return verdict_passes(judge(job, check, answers));
    }
}

static void adopt(void *pointer, const Sections *answers)
{
    Job *job = pointer;
    job_pictures_adopt(job->pictures, N_SCENES, answers);
}

static void add_pictures(const void *pointer, const Sections *answers, Result *result)
{
    const Job *job = pointer;
    job_pictures_report(job->pictures, N_SCENES, answers, result);
}

const Judge judge_01 = {
    .lab = "01-naive-2d",
    .checks = checks,
    .n_checks = sizeof checks / sizeof *checks,
    .job_new = job_new,
    .job_free = job_free,
    .judge = judge,
    .write_alone = write_alone,
    .passes_alone = passes_alone,
    .adopt = adopt,
    .add_pictures = add_pictures,
};
