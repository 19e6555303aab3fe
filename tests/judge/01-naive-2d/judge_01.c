// Judge of lab 01: overlaps_N_Nearer on chosen inputs, and pictures of the naive renderer.
#include "judge.h"

#include "alone_picture.h"
#include "job_scene.h"
#include "jobs.h"
#include "message.h"
#include "oracle2d.h"
#include "words.h"

#include <math.h>
#include <string.h>

// The scenes, in the order of the job; each check looks at a range of them.
enum {
    WIDE = 0,    // 317x211
    HIGH = 1,    // 48x64
    RANDOM = 2,  // two more
    ORDER = 4,
    EDGES = 5,
    DEPTHS = EDGES + 6,
    N_EDGES = 7,
    N_SCENES = EDGES + N_EDGES,
};
static const char *const edge_names[DEPTHS - EDGES] = {"none",     "outside", "borders",
                                                       "touching", "huge",    "tiny"};

// How many inputs each of the three function checks tries, one range after the other.
enum { N_INSIDE = 3000, N_BOUNDARY = 1000, N_NEARER = 1000 };
enum { N_OVERLAPS = N_INSIDE + N_BOUNDARY + N_NEARER };

typedef struct Job01 {
    Job job;
    OverlapJob overlaps[N_OVERLAPS];
    JobScene scenes[N_SCENES];
} Job01;

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

// Points that an epsilon would put on the wrong side, and radius 0: a pixel's offset from the
// centre. The squares are exact in float. A root may be off by a few units in the last place;
// these are off by sixteen at least.
static const struct {
    float radius, dx, dy;
} beside_boundary[] = {
    {1, 1, 0x1p-4f},
    {5, 5, 0x1p-4f},
    {41, 41, 0x1p-4f},
    {200, 200, 0x1p-4f},
    {1, 1, 0x1p-6f},
    {1, 1, 0x1p-9f},
    {0, 0, 0},
    {0, 0, 0x1p-13f},
    {0, 1, 0},
    {0x1p-4f, 0x1p-4f, 0},
    {0x1p-4f, 0x1p-4f, 0x1p-13f},
};
enum { N_BESIDE_BOUNDARY = 4 * COUNT(beside_boundary) };

// Number i of these, turned by a quarter for each i of the same row.
static OverlapJob boundary_edge(int i)
{
    const int row = i / 4, sign = i % 2 == 0 ? 1 : -1, is_turned = i % 4 >= 2;
    const float dx = (float)sign * beside_boundary[row].dx;
    const float dy = (float)sign * beside_boundary[row].dy;
    return (OverlapJob){.x = 210,
                        .y = 220,
                        .circle = {.x = 210 - (is_turned ? dy : dx),
                                   .y = 220 - (is_turned ? dx : dy),
                                   .radius = beside_boundary[row].radius,
                                   .depth = 0.5f},
                        .minDepth = INFINITY};
}

// Depths that are one float apart or equal, and some of any size: the circle's and minDepth.
static const float depth_pairs[][2] = {
    {0.5f, 0x1.000002p-1f}, {0x1.000002p-1f, 0.5f}, {0.5f, 0x1.fffffep-2f}, {0x1.fffffep-2f, 0.5f},
    {0.5f, 0.5f},           {0.0f, -0.0f},          {-0.0f, 0.0f},          {0.0f, 0x1p-100f},
    {0x1p-100f, 0.0f},      {-0x1p-100f, 0.0f},     {1000, 0x1.f40002p9f},  {0x1.f40002p9f, 1000},
    {1e30f, INFINITY},      {3e38f, INFINITY},      {1e30f, 3e38f},         {3e38f, 1e30f},
    {-1e30f, 1e30f},        {-3e38f, -1e30f},
};

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
    for (int i = 0; i < N_BESIDE_BOUNDARY; i++) {
        jobs[N_INSIDE + i] = boundary_edge(i);
    }
    for (int i = 0; i < COUNT(depth_pairs); i++) {
        OverlapJob *job = &jobs[N_INSIDE + N_BOUNDARY + i];
        job->circle.depth = depth_pairs[i][0];
        job->minDepth = depth_pairs[i][1];
    }
}

static int draw_scenes(Random *random, JobScene scenes[N_SCENES])
{
    int result = job_scene_random(&scenes[WIDE], random, 120, 24, 317, 211);
    result |= job_scene_random(&scenes[HIGH], random, 30, 12, 48, 64);
    result |= job_scene_random(&scenes[RANDOM], random, 200, 16, 128, 96);
    result |= job_scene_random(&scenes[RANDOM + 1], random, 7, 40, 96, 100);
    job_scene_spread_depths(&scenes[RANDOM + 1]);
    result |= job_scene_named(&scenes[ORDER], random, "equal-depths", 96, 64);
    for (int k = EDGES; k < DEPTHS; k++) {
        result |= job_scene_named(&scenes[k], random, edge_names[k - EDGES], 64, 48);
    }
    result |= job_scene_depths(&scenes[DEPTHS], random);
    for (int k = 0; result == 0 && k < N_SCENES; k++) {
        result = job_scene_expect(&scenes[k]);
    }
    return result;
}

static int draw(void *pointer, Random *random)
{
    Job01 *job = pointer;
    for (int k = 0; k < N_SCENES; k++) {
        job_list_picture(&job->job, &job->scenes[k].picture);
    }
    draw_overlaps(random, job->overlaps);
    return draw_scenes(random, job->scenes);
}

static void release(void *pointer)
{
    Job01 *job = pointer;
    for (int k = 0; k < N_SCENES; k++) {
        job_scene_free(&job->scenes[k]);
    }
}

static int write_scene(const void *pointer, int k, FILE *file)
{
    return job_scene_write(&((const Job01 *)pointer)->scenes[k], k, file);
}

// ---- overlaps_N_Nearer --------------------------------------------------------------------------

// How far the pixel is outside the circle, in squares: 0 on the boundary, less inside.
static double outside_by(OverlapJob in)
{
    const double dx = in.x - (double)in.circle.x, dy = in.y - (double)in.circle.y;
    return dx * dx + dy * dy - (double)in.circle.radius * in.circle.radius;
}

// Does a wrong answer fit a mistake? Such differences are less than an eighth, and an epsilon is.
#define SMALL 0.125
typedef int Fits(OverlapJob in, int found);

static int is_equal_depth(OverlapJob in, int found)
{
    return found && in.circle.depth == in.minDepth;
}

static int is_little_farther(OverlapJob in, int found)
{
    return found && in.circle.depth >= in.minDepth && (double)in.circle.depth - in.minDepth < SMALL;
}

static int is_not_nearer(OverlapJob in, int found)
{
    return found && in.circle.depth >= in.minDepth;
}

static int is_little_nearer(OverlapJob in, int found)
{
    return !found && (double)in.minDepth - in.circle.depth < SMALL;
}

static int is_on_boundary(OverlapJob in, int found)
{
    return !found && outside_by(in) == 0;
}

static int has_no_radius(OverlapJob in, int found)
{
    return !found && in.circle.radius == 0;
}

static int is_little_outside(OverlapJob in, int found)
{
    return found && outside_by(in) > 0 && outside_by(in) < SMALL;
}

static int is_in_square(OverlapJob in, int found)
{
    return found && outside_by(in) > 0 && fabs(in.x - (double)in.circle.x) <= in.circle.radius &&
           fabs(in.y - (double)in.circle.y) <= in.circle.radius;
}

// The first that fits every wrong answer is named.
static const struct {
    Fits *fits;
    Cause cause;
} overlap_mistakes[] = {
    {is_equal_depth,
     {"nearer is strict: a circle at equal depth does not take the pixel",
      MISTAKE_LATER_OF_EQUALS}},
    {is_little_farther, {.says = "a circle farther by however little is not nearer: no epsilon"}},
    {is_not_nearer, {.says = "the circle is not nearer than what the pixel has seen"}},
    {is_little_nearer, {.says = "a circle nearer by however little takes the pixel: no epsilon"}},
    {has_no_radius, {.says = "a circle of radius 0 covers its centre: the boundary belongs to it"}},
    {is_on_boundary,
     {"strict where it should not be: the boundary belongs to the circle",
      MISTAKE_STRICT_BOUNDARY}},
    {is_little_outside, {.says = "a pixel outside by however little is outside: no epsilon"}},
    {is_in_square, {.says = "the pixel is in the circle's bounding square but not in the circle"}},
};

// The right answer for a sample point that is `offset` away from the pixel's.
static int expected_overlap(OverlapJob in, double offset)
{
    return oracle2d_covers(in.circle, in.x + offset, in.y + offset) &&
           in.circle.depth < in.minDepth;
}

static int overlap_agrees(const void *pointer, int i, const void *answers, int mistake)
{
    static const double offsets[] = {0, 0.5, -0.5};
    const Job01 *job = pointer;
    return (((const i32 *)answers)[i] != 0) == expected_overlap(job->overlaps[i], offsets[mistake]);
}

// Do all answers come of a sample point that is shifted in the same way?
static int is_shifted(const Job01 *job, Range range, const void *answers, int mistake)
{
    int i = range.first;
    while (i < range.first + range.n && overlap_agrees(job, i, answers, mistake)) {
        i++;
    }
    return i == range.first + range.n;
}

// Does a mistake fit all wrong answers?
static int fits_all(const Job01 *job, Range range, const i32 *answers, Fits *fits)
{
    for (int i = range.first; i < range.first + range.n; i++) {
        if (!overlap_agrees(job, i, answers, 0) && !fits(job->overlaps[i], answers[i] != 0)) {
            return 0;
        }
    }
    return 1;
}

// A cause is named only when it explains every wrong answer.
static Cause explain_overlaps(const void *job, Range range, const void *answers)
{
    if (is_shifted(job, range, answers, 1) || is_shifted(job, range, answers, 2)) {
        return (Cause){"shifted by half a pixel: the sample point is the integer coordinate",
                       MISTAKE_SHIFTED_HALF};
    }
    for (int i = 0; i < COUNT(overlap_mistakes); i++) {
        if (fits_all(job, range, answers, overlap_mistakes[i].fits)) {
            return overlap_mistakes[i].cause;
        }
    }
    return (Cause){0};
}

static char *describe_overlap(const void *pointer, int i, const void *answers)
{
    const OverlapJob in = ((const Job01 *)pointer)->overlaps[i];
    const int found = ((const i32 *)answers)[i] != 0;
    return message_new(
        "pixel (%d, %d), circle at %s depth %.9g, minDepth %.9g: found %d, expected %d", in.x, in.y,
        words_circle(in.circle).text, in.circle.depth, in.minDepth, found, !found);
}

static const Function overlaps = {.section = "overlaps",
                                  .n = N_OVERLAPS,
                                  .answer_bytes = sizeof(i32),
                                  .describe = describe_overlap,
                                  .agrees = overlap_agrees,
                                  .counted = "inputs",
                                  .explain = explain_overlaps};

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

// Which of the job's scenes a task is tried with, as scenes 0 and on.
static const Range own_pixel_scenes = {.first = WIDE, .n = RANDOM - WIDE};
static const Range renderer_scenes = {.first = RANDOM, .n = N_SCENES - RANDOM};

static int write_alone(const void *pointer, const char *task, FILE *file)
{
    const Job01 *job = pointer;
    if (strcmp(task, "overlaps_N_Nearer") == 0) {
        return 0;
    }
    const Range scenes = strcmp(task, "own_pixel") == 0 ? own_pixel_scenes : renderer_scenes;
    int result = 0;
    for (int k = 0; result == 0 && k < scenes.n; k++) {
        result = job_scene_write(&job->scenes[scenes.first + k], k, file);
    }
    return result;
}

static int is_drawn(const void *pointer, int k, Range scenes, ColorAt *color_at,
                    const Sections *answers)
{
    const Scene2D *scene = &((const Job01 *)pointer)->scenes[k].scene;
    return alone_picture_is_right(answers, k - scenes.first, scene->width, scene->height, 0,
                                  color_at, scene);
}

static int own_color_is_drawn(const void *job, int k, const Sections *answers)
{
    return is_drawn(job, k, own_pixel_scenes, own_color, answers);
}

static int nearest_is_drawn(const void *job, int k, const Sections *answers)
{
    return is_drawn(job, k, renderer_scenes, nearest_color, answers);
}

static int keeps_inside(const void *pointer, int k, const Sections *answers)
{
    const Scene2D *scene = &((const Job01 *)pointer)->scenes[k].scene;
    return alone_picture_keeps_inside(answers, k - own_pixel_scenes.first, scene->width,
                                      scene->height);
}

// ---- The judge ----------------------------------------------------------------------------------

static const JudgeCheck checks[] = {
    {"overlaps-inside", "Pixels clearly inside and outside a circle", "overlaps_N_Nearer", 15,
     .function = &overlaps, .range = {0, N_INSIDE}},
    {"overlaps-boundary", "Pixels on the boundary and just beside it", "overlaps_N_Nearer", 10,
     .function = &overlaps, .range = {N_INSIDE, N_BOUNDARY}},
    {"overlaps-nearer", "Nearer, equally far and farther than minDepth", "overlaps_N_Nearer", 15,
     .function = &overlaps, .range = {N_INSIDE + N_BOUNDARY, N_NEARER}},
    {"own_pixel-picture", "Every work-item draws its own pixel", "own_pixel", 10, "*",
     .scene = judge_picture, .range = {WIDE, 2}, .alone_scene = own_color_is_drawn},
    {"own_pixel-padding", "Nothing is written outside the picture", "own_pixel", 10,
     .scene = judge_padding, .range = {0, N_SCENES}, .alone_scene = keeps_inside,
     .alone_range = {WIDE, 2}},
    {"renderer-random", "Random scenes", "implicit2DRenderer", 20, "*", .scene = judge_picture,
     .range = {RANDOM, 2}, .alone_scene = nearest_is_drawn},
    {"renderer-order", "Of equal depths the lower index wins", "implicit2DRenderer", 10, "*",
     .scene = judge_picture, .range = {ORDER, 1}, .alone_scene = nearest_is_drawn},
    {"renderer-edges", "No circles, far outside, touching, huge, tiny, any depth",
     "implicit2DRenderer", 10, "*", .scene = judge_picture, .range = {EDGES, N_EDGES},
     .alone_scene = nearest_is_drawn},
};

static const JobPart parts[] = {PART("overlaps", "overlaps_N_Nearer", Job01, overlaps)};

const Judge judge_01 = {
    .lab = "01-naive-2d",
    .checks = checks,
    .n_checks = COUNT(checks),
    .job_bytes = sizeof(Job01),
    .draw = draw,
    .release = release,
    .parts = parts,
    .n_parts = COUNT(parts),
    .write_scene = write_scene,
    .n_scenes = N_SCENES,
    .write_alone = write_alone,
    .adopts = 1,
};
