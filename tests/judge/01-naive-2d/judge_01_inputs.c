// Lab 01: rolling the inputs of overlaps_N_Nearer. See judge_01.h.
#include "judge_01.h"

#include "oracle2d.h"
#include "sent.h"

#include <float.h>
#include <math.h>

double outside_by_01(OverlapJob in)
{
    const double dx = in.x - (double)in.circle.x, dy = in.y - (double)in.circle.y;
    return dx * dx + dy * dy - (double)in.circle.radius * in.circle.radius;
}

// A pixel within two radii of a random circle that is nearer than minDepth, and not near its
// boundary: that is for others.
static OverlapJob roll_inside(Random *random)
{
    OverlapJob job = {.minDepth = 0.75f};
    do {
        job.circle.x = random_grid(random, -10, 300);
        job.circle.y = random_grid(random, -10, 300);
        job.circle.radius = random_grid(random, 1, 60);
        job.circle.depth = 0.25f;
        job.x = (int)lrintf(job.circle.x +
                            (float)random_integer(random, -1000, 1000) / 500 * job.circle.radius);
        job.y = (int)lrintf(job.circle.y +
                            (float)random_integer(random, -1000, 1000) / 500 * job.circle.radius);
    } while (fabs(outside_by_01(job)) < SMALL);
    return job;
}

// A pixel exactly on the boundary (a Pythagorean triple from the centre), or one step beside it.
static OverlapJob roll_boundary(Random *random)
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
// centre. The squares are exact in float; in the last rows a sum may be rounded, and is yet above
// or at radius², in whatever order it is computed. The root of some of these is rounded to the
// radius.
static const struct {
    float radius, dx, dy;
    int is_at_0;  // of pixel (0, 0), where a centre may have any fraction
} beside_boundary[] = {
    {1, 1, 0x1p-4f, 0},
    {5, 5, 0x1p-4f, 0},
    {41, 41, 0x1p-4f, 0},
    {200, 200, 0x1p-4f, 0},
    {1, 1, 0x1p-6f, 0},
    {1, 1, 0x1p-9f, 0},
    {0, 0, 0, 0},
    {0, 0, 0x1p-13f, 0},
    {0, 1, 0, 0},
    {0x1p-4f, 0x1p-4f, 0, 0},
    {0x1p-4f, 0x1p-4f, 0x1p-13f, 0},
    {1, 1, 0x1.6ap-12f, 1},
    {5, 5, 0x1.6ap-10f, 1},
    {5, 3, 4 + 0x1p-21f, 1},
    {0x1p-20f, 0x1p-20f, 0x1p-30f, 1},
    {0x1p-30f, 0x1p-30f, 0x1p-40f, 1},
    {0x1p-30f, 0x1p-30f, 0, 1},
};
enum { N_BESIDE_BOUNDARY = 4 * COUNT(beside_boundary) };

// Number i of these, turned by a quarter for each i of the same row.
static OverlapJob boundary_edge(int i)
{
    const int row = i / 4, sign = i % 2 == 0 ? 1 : -1, is_turned = i % 4 >= 2;
    const float dx = (float)sign * beside_boundary[row].dx;
    const float dy = (float)sign * beside_boundary[row].dy;
    const int x = beside_boundary[row].is_at_0 ? 0 : 210,
              y = beside_boundary[row].is_at_0 ? 0 : 220;
    return (OverlapJob){.x = x,
                        .y = y,
                        .circle = {.x = (float)x - (is_turned ? dy : dx),
                                   .y = (float)y - (is_turned ? dx : dy),
                                   .radius = beside_boundary[row].radius,
                                   .depth = 0.5f},
                        .minDepth = INFINITY};
}

// Depths that are one float apart or equal, and some of any size: the circle's and minDepth.
static const float depth_pairs[][2] = {
    {0.5f, 0x1.000002p-1f}, {0x1.000002p-1f, 0.5f}, {0.5f, 0x1.fffffep-2f}, {0x1.fffffep-2f, 0.5f},
    {0.5f, 0.5f},           {0.0f, -0.0f},          {-0.0f, 0.0f},          {0.0f, 0x1p-100f},
    {0x1p-100f, 0.0f},      {-0x1p-100f, 0.0f},     {1000, 0x1.f40002p9f},  {0x1.f40002p9f, 1000},
    {1e30f, INFINITY},      {FLT_MAX, INFINITY},    {1e30f, 3e38f},         {3e38f, 1e30f},
    {-1e30f, 1e30f},        {-3e38f, -1e30f},
};

// The centre of a circle, with a depth below, at or above minDepth; negative ones and infinity too.
static OverlapJob roll_nearer(Random *random)
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

// ---- What pictures send -------------------------------------------------------------------------

// A pixel in or outside a circle that is nearer than minDepth, and not near its boundary.
static OverlapJob roll_pixel(Random *random, int x, int y, int is_inside)
{
    OverlapJob job = {.x = x, .y = y, .minDepth = 0.75f};
    do {
        const int radius = (int)random_integer(random, 1, 60);
        job.circle = (Circle){.x = (float)x + random_grid(random, -2 * radius, 2 * radius),
                              .y = (float)y + random_grid(random, -2 * radius, 2 * radius),
                              .radius = (float)radius,
                              .depth = 0.25f};
    } while (fabs(outside_by_01(job)) < SMALL || (outside_by_01(job) < 0) != is_inside);
    return job;
}

// Every pixel that some picture has, once inside and once outside.
static void roll_pixels(Random *random, OverlapJob jobs[2 * N_PIXELS])
{
    int n = 0;
    for (int y = 0; y < HIGH_ROWS; y++) {
        for (int x = 0; x < (y < WIDE_ROWS ? WIDE_COLUMNS : HIGH_COLUMNS); x++) {
            jobs[n++] = roll_pixel(random, x, y, 0);
            jobs[n++] = roll_pixel(random, x, y, 1);
        }
    }
}

// Where the calls of a scene go: a place in each range.
typedef struct SentCalls {
    Sent inside, boundary, nearer;
} SentCalls;

// Sort a call into the range of what decides its answer: the depths, or else the place, with depths
// that do not matter.
static void sort_call(Random *random, OverlapJob job, SentCalls *sent)
{
    const double outside_by = outside_by_01(job);
    OverlapJob plain = job;
    plain.circle.depth = 0.25f;
    plain.minDepth = 0.75f;
    if (oracle2d_is_ambiguous(job.circle, job.x, job.y)) {
        return;
    }
    if (fabs(outside_by) < SMALL) {
        sent_keep(&sent->boundary, random, &plain);
        return;
    }
    sent_keep(&sent->inside, random, &plain);
    if (outside_by < 0) {
        sent_keep(&sent->nearer, random, &job);
    }
}

// The calls that the kernel makes for some pixels of a scene.
static void take_calls(Random *random, const Scene2D *scene, SentCalls *sent)
{
    const int n_pixels = scene->n_circles < 1000 ? 200 : 1;
    for (int i = 0; i < n_pixels; i++) {
        OverlapJob job = {.x = (int)random_integer(random, 0, scene->width - 1),
                          .y = (int)random_integer(random, 0, scene->height - 1),
                          .minDepth = INFINITY};
        for (int k = 0; k < scene->n_circles; k++) {
            job.circle = scene->circles[k];
            sort_call(random, job, sent);
            if (job.circle.depth < job.minDepth && oracle2d_covers(job.circle, job.x, job.y)) {
                job.minDepth = job.circle.depth;
            }
        }
    }
}

// ---- All ----------------------------------------------------------------------------------------

void roll_overlaps_01(Random *random, const JobScene scenes[N_SCENES], OverlapJob jobs[N_OVERLAPS])
{
    OverlapJob *inside = jobs, *boundary = inside + N_INSIDE, *nearer = boundary + N_BOUNDARY;
    for (int i = 0; i < N_INSIDE; i++) {
        inside[i] = roll_inside(random);
    }
    for (int i = 0; i < N_BOUNDARY; i++) {
        boundary[i] = i < N_BESIDE_BOUNDARY ? boundary_edge(i) : roll_boundary(random);
    }
    for (int i = 0; i < N_NEARER; i++) {
        nearer[i] = roll_nearer(random);
        if (i < COUNT(depth_pairs)) {
            nearer[i].circle.depth = depth_pairs[i][0];
            nearer[i].minDepth = depth_pairs[i][1];
        }
    }
    roll_pixels(random, inside + N_ROLLED_INSIDE);
    for (int k = 0; k < N_SCENES; k++) {
        SentCalls sent = {
            SENT_TO(inside + N_INSIDE - (k + 1) * N_SENT_INSIDE, N_SENT_INSIDE),
            SENT_TO(boundary + N_BOUNDARY - (k + 1) * N_SENT_BOUNDARY, N_SENT_BOUNDARY),
            SENT_TO(nearer + N_NEARER - (k + 1) * N_SENT_NEARER, N_SENT_NEARER)};
        take_calls(random, &scenes[k].scene, &sent);
    }
}
