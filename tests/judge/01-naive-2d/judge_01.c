// Judge of lab 01: overlaps_N_Nearer on chosen inputs, and pictures of the naive renderer. Read
// next: judge_01.h.
#include "judge_01.h"

#include "alone_picture.h"

#include <math.h>
#include <string.h>

static const char *const edge_names[PILE - NAMED] = {"outside", "borders", "touching", "huge",
                                                     "tiny"};

static int roll_scenes(Random *random, JobScene scenes[N_SCENES])
{
    int result = job_scene_random(&scenes[WIDE], random, 120, 24, WIDE_COLUMNS, WIDE_ROWS);
    result |= job_scene_random(&scenes[HIGH], random, 30, 12, HIGH_COLUMNS, HIGH_ROWS);
    result |= job_scene_random(&scenes[RANDOM], random, 200, 16, 128, 96);
    result |= job_scene_random(&scenes[RANDOM + 1], random, 7, 40, 96, 100);
    job_scene_cover_second(&scenes[RANDOM]);
    job_scene_spread_depths(&scenes[RANDOM + 1]);
    result |= job_scene_named(&scenes[ORDER], random, "equal-depths", 96, 64);
    result |= job_scene_named(&scenes[NONE], random, "none", 64, 48);
    for (int k = NAMED; k < PILE; k++) {
        result |= job_scene_named(&scenes[k], random, edge_names[k - NAMED], 64, 48);
    }
    result |= job_scene_depths(&scenes[DEPTHS], random);
    result |= job_scene_pile(&scenes[PILE], random);
    for (int k = 0; result == 0 && k < N_SCENES; k++) {
        result = job_scene_expect(&scenes[k]);
    }
    return result;
}

static int roll(void *pointer, Random *random)
{
    Job01 *job = pointer;
    if (roll_scenes(random, job->scenes) != 0) {
        return -1;
    }
    roll_overlaps_01(random, job->scenes, job->overlaps);
    return 0;
}

// ---- Alone --------------------------------------------------------------------------------------

// The hole of overlaps_N_Nearer while another task is tried.
static int stub_overlaps(int x, int y, Circle circle, float minDepth)
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
        if (stub_overlaps(x, y, circle, minDepth)) {
            minDepth = circle.depth;
            memcpy(color, &circle.r, 4 * sizeof *color);
        }
    }
}

// The colour by the stub of the loop.
static void own_color(const void *pointer, int x, int y, float color[4])
{
    const Scene2D *scene = pointer;
    color[0] = (float)x;
    color[1] = (float)y;
    color[2] = (float)scene->n_circles;
    color[3] = 1;
}

static int write_alone(const void *pointer, const char *task, FILE *file)
{
    const Job01 *job = pointer;
    if (strcmp(task, "overlaps_N_Nearer") == 0) {
        return 0;
    }
    int result = 0;
    for (int k = 0; result == 0 && k < N_SCENES; k++) {
        result = job_scene_write(&job->scenes[k], k, file);
    }
    return result;
}

static int is_drawn(const void *pointer, int k, ColorAt *color_at, const Sections *answers)
{
    const Scene2D *scene = &((const Job01 *)pointer)->scenes[k].scene;
    return alone_picture_is_right(answers, k, scene->width, scene->height, 0, color_at, scene);
}

static int own_color_is_drawn(const void *job, int k, const Sections *answers)
{
    return is_drawn(job, k, own_color, answers);
}

static int nearest_is_drawn(const void *job, int k, const Sections *answers)
{
    return is_drawn(job, k, nearest_color, answers);
}

static int expect_own(const void *pointer, int k, ExpectedPicture *expected)
{
    const Scene2D *scene = &((const Job01 *)pointer)->scenes[k].scene;
    return alone_picture_expect(scene->width, scene->height, 0, own_color, scene, expected);
}

static int expect_nearest(const void *pointer, int k, ExpectedPicture *expected)
{
    const JobScene *scene = &((const Job01 *)pointer)->scenes[k];
    expected_picture_recognise(expected, job_scene_draw_squares, scene);
    return alone_picture_expect(scene->scene.width, scene->scene.height, 0, nearest_color,
                                &scene->scene, expected);
}

static Cause own_cause(const void *job, const JudgeCheck *check, const Sections *answers)
{
    return alone_pictures_look(job, check->range.first, check->range.n, expect_own, answers);
}

static Cause nearest_cause(const void *job, const JudgeCheck *check, const Sections *answers)
{
    return alone_pictures_look(job, check->range.first, check->range.n, expect_nearest, answers);
}

static int keeps_inside(const void *pointer, int k, const Sections *answers)
{
    const Scene2D *scene = &((const Job01 *)pointer)->scenes[k].scene;
    return alone_picture_keeps_inside(answers, k, scene->width, scene->height);
}

// ---- The judge ----------------------------------------------------------------------------------

static const JudgeCheck checks[] = {
    {"overlaps-inside", "Pixels clearly inside and outside a circle", "overlaps_N_Nearer",
     .function = &overlaps_01, .range = {0, N_INSIDE}},
    {"overlaps-boundary", "Pixels on the boundary and just beside it", "overlaps_N_Nearer",
     .function = &overlaps_01, .range = {N_INSIDE, N_BOUNDARY}},
    {"overlaps-nearer", "Nearer, equally far and farther than minDepth", "overlaps_N_Nearer",
     .function = &overlaps_01, .range = {N_INSIDE + N_BOUNDARY, N_NEARER}},
    {"own_pixel-picture", "Every work-item draws its own pixel", "own_pixel", "*",
     .scene = judge_picture, .range = {0, N_SCENES}, .alone_scene = own_color_is_drawn,
     .alone_cause = own_cause},
    {"own_pixel-padding", "Nothing is written outside the picture", "own_pixel",
     .scene = judge_padding, .range = {0, N_SCENES}, .alone_scene = keeps_inside},
    {"renderer-random", "Random scenes", "implicit2DRenderer", "*", .scene = judge_picture,
     .range = {WIDE, 4}, .alone_scene = nearest_is_drawn, .alone_cause = nearest_cause},
    {"renderer-order", "Of equal depths the lower index wins", "implicit2DRenderer", "*",
     .scene = judge_picture, .range = {ORDER, 1}, .alone_scene = nearest_is_drawn,
     .alone_cause = nearest_cause},
    {"renderer-edges", "No circles, far outside, touching, huge, tiny, any depth, many",
     "implicit2DRenderer", "*", .scene = judge_picture, .range = {EDGES, N_EDGES},
     .alone_scene = nearest_is_drawn, .alone_cause = nearest_cause},
};

static const JobPart parts[] = {INPUTS("overlaps", "overlaps_N_Nearer", Job01, overlaps)};

const Judge judge_01 = {
    .lab = "01-naive-2d",
    .checks = checks,
    .n_checks = COUNT(checks),
    .job_bytes = sizeof(Job01),
    .roll = roll,
    .parts = parts,
    .n_parts = COUNT(parts),
    .scenes = SCENES(job_scene_kind, Job01, scenes),
    .scene_steps = {{"picture", "in implicit2DRenderer", NULL}},
    .write_alone = write_alone,
    .adopts = 1,
};
