// Lab 10's paint_row: its inputs, and what must come out. Distances are on the grid of 1/16 px,
// large ones on that of 1/2 px, so that every comparison is exact; or off the grid, and then no
// pixel is so near to the boundary that rounding decides. An answer is right or wrong to the bit.
#include "judge_10.h"

#include "message.h"
#include "random3d.h"
#include "words.h"

#include <float.h>
#include <math.h>

// ---- Inputs -----------------------------------------------------------------------------------

// How far a pixel on the boundary is from the centre along x and y: on the slope of the circle, at
// its top or bottom, where it only touches the row, and at its side.
static const struct {
    float x, y, radius;
} on_boundary[] = {{3, 4, 5}, {0, 5, 5}, {5, 0, 5}};

// How far the centre of a large circle may be from the row, and from its pixels. In half pixels
// all distances and radii are below 2^12, and the squares, and the sum of two, below 2^24: exact in
// float.
enum { FAR_PIXELS = 1000, FAR_UNITS = 200 };

// Half a pixel, as often as that.
static float random_halves(Random *random, int min, int max)
{
    return (float)random_integer(random, 2 * min, 2 * max) / 2;
}

// The radius, in half pixels, with which a circle's boundary is next to a pixel of the row.
static float radius_near(float dx, float dy)
{
    return roundf(2 * hypotf(dx, dy)) / 2;
}

float random_off_grid(Random *random)
{
    return (float)random_integer(random, 1, 0xffff) / 0x100000;
}

static int is_float(double value)
{
    return (double)(float)value == value;
}

// There are three operations, and at most 2^-24 of the sum comes from each.
int row_10_is_decided(const CircleRowJob *job)
{
    const double dy_squared = (double)job->dy * (double)job->dy;
    int n_decided = 0;
    for (int i = 0; i < ROW_PIXELS; i++) {
        const double sum = (double)job->dx_squared[i] + dy_squared;
        n_decided += (is_float(dy_squared) && is_float(sum)) ||
                     fabs(sum - (double)job->radius_squared) > 3 * 0x1p-24 * sum;
    }
    return n_decided == ROW_PIXELS;
}

// A circle near the row, or a large one far from it; in a third of all cases with a pixel exactly
// on its boundary, or outside of it by one float, and in another third off the grid, with a pixel
// just inside or outside.
static CircleRowJob roll_any_row(Random *random, enum RowRange range)
{
    CircleRowJob job = {.color = (u32)random_bits(random)};
    const int is_exact = one_in(random, 3);
    const int is_off_grid = !is_exact && one_in(random, 2);
    const int is_far = one_in(random, 3);
    const float unit = is_far ? (float)random_integer(random, 1, FAR_UNITS)
                              : (float)random_integer(random, 1, 32) / 16;
    const int64_t kind = random_integer(random, 0, COUNT(on_boundary) - 1);
    const float to_x = on_boundary[kind].x * unit, to_y = on_boundary[kind].y * unit;
    const float pixel = (float)random_integer(random, 0, ROW_PIXELS - 1);
    float x = is_exact ? pixel + to_x
              : is_far ? random_halves(random, -FAR_PIXELS, FAR_PIXELS)
                       : random_grid(random, -8, ROW_PIXELS + 8);
    job.dy = is_exact ? (float)random_sign(random) * to_y
             : is_far ? random_halves(random, -FAR_PIXELS, FAR_PIXELS)
                      : random_grid(random, -12, 12);
    float radius = is_exact ? on_boundary[kind].radius * unit
                   : is_far ? radius_near(pixel - x, job.dy)
                            : random_grid(random, 0, 16);
    if (is_off_grid) {
        x += random_off_grid(random);
        job.dy += random_off_grid(random);
        radius = hypotf(pixel - x, job.dy) * (1 + (float)random_sign(random) * 0x1p-18f);
    }
    job.radius_squared = radius * radius;
    if (is_exact && one_in(random, 2)) {
        job.radius_squared = nextafterf(job.radius_squared, 0);
    }
    // Black is a colour as any other.
    job.color = one_in(random, 8) ? 0 : job.color;
    for (int i = 0; i < ROW_PIXELS; i++) {
        const float dx = (float)i - x;
        job.dx_squared[i] = dx * dx;
        job.open[i] = range == ROWS_PAINTED && one_in(random, 2) ? 0 : -1;
        job.colors[i] = job.open[i] || one_in(random, 8) ? 0 : (u32)random_bits(random);
    }
    return job;
}

static CircleRowJob roll_row(Random *random, enum RowRange range)
{
    CircleRowJob job;
    do {
        job = roll_any_row(random, range);
    } while (!row_10_is_decided(&job));
    return job;
}

// A circle of radius 0 exactly on an open pixel: it covers that one.
static void make_point(Random *random, CircleRowJob *job)
{
    const int64_t pixel = random_integer(random, 0, ROW_PIXELS - 1);
    for (int i = 0; i < ROW_PIXELS; i++) {
        const float dx = (float)(i - pixel);
        job->dx_squared[i] = dx * dx;
    }
    job->dy = job->radius_squared = 0;
    job->open[pixel] = -1;
    job->colors[pixel] = 0;
    job->color |= 1;  // not black: that it was painted is seen
}

// The last one of each range is a point, in every job.
void roll_rows_10(Random *random, Job10 *job)
{
    for (int i = 0; i < COUNT(job->rows); i++) {
        job->rows[i] = roll_row(random, (enum RowRange)(i / N_ROW_INPUTS));
        if (i % N_ROW_INPUTS == N_ROW_INPUTS - 1) {
            make_point(random, &job->rows[i]);
        }
    }
}

#define GIVEN                                                                                      \
    const CircleRowJob *in = &((const Job10 *)job)->rows[i];                                       \
    const CircleRowAnswer *found = (const CircleRowAnswer *)answers + i

// ---- Right --------------------------------------------------------------------------------------

typedef struct Pixel {
    u32 color;
    i32 open;
} Pixel;

static Pixel pixel_if(const CircleRowJob *in, int i, int is_covered)
{
    return (Pixel){is_covered && in->open[i] ? in->color : in->colors[i],
                   is_covered ? 0 : in->open[i]};
}

static int is_within(const CircleRowJob *in, int i, double limit)
{
    return in->dx_squared[i] + (double)in->dy * in->dy <= limit;
}

static Pixel right(const CircleRowJob *in, int i)
{
    return pixel_if(in, i, is_within(in, i, in->radius_squared));
}

static int is_pixel(const CircleRowAnswer *found, int i, Pixel expected)
{
    return found->colors[i] == expected.color && found->open[i] == expected.open;
}

// The first pixel of a row that is another one, or ROW_PIXELS.
static int first_wrong(const CircleRowJob *in, const CircleRowAnswer *found)
{
    int i = 0;
    while (i < ROW_PIXELS && is_pixel(found, i, right(in, i))) {
        i++;
    }
    return i;
}

RIGHT(is_right, first_wrong(in, found) == ROW_PIXELS)

// ---- Mistakes -----------------------------------------------------------------------------------

// Pixel number k has the colour `color` before, `open` says whether it is open, and `expected` is
// what comes of it.
#define PIXELS(name, pixel, ...)                                                                   \
    for (int k = 0; number == 0 && is_row && k < ROW_PIXELS; k++) {                                \
        const double dx2 = in->dx_squared[k];                                                      \
        const int is_covered = is_within(in, k, r2);                                               \
        const u32 color = in->colors[k];                                                           \
        const i32 open = in->open[k];                                                              \
        const Pixel expected = right(in, k);                                                       \
        (void)dx2, (void)is_covered, (void)color, (void)open, (void)expected;                      \
        is_row = is_pixel(found, k, pixel);                                                        \
    }                                                                                              \
    EACH(name, is_row, __VA_ARGS__)

// By what is covered.
#define COVERS(name, covers, ...) PIXELS(name, pixel_if(in, k, covers), __VA_ARGS__)
#define DY_NOT_SQUARED                                                                             \
    "that is as if dy were added as it is: dx_squared is squared already, dy is not"

static int n_covered(const CircleRowJob *in)
{
    int n = 0;
    for (int i = 0; i < ROW_PIXELS; i++) {
        n += is_within(in, i, in->radius_squared);
    }
    return n;
}

static int n_open(const CircleRowJob *in)
{
    int n = 0;
    for (int i = 0; i < ROW_PIXELS; i++) {
        n += in->open[i] != 0;
    }
    return n;
}

// By what stays open.
#define OPENS_AGAIN "what was closed already is open again: a pixel never opens"
#define STAYS(name, is_open, ...) PIXELS(name, ((Pixel){expected.color, is_open}), __VA_ARGS__)

// Each pixel is right, or is covered by so much too little.
static int is_covered_within(const CircleRowJob *in, const CircleRowAnswer *found, double limit)
{
    int i = 0;
    while (i < ROW_PIXELS && (is_pixel(found, i, right(in, i)) ||
                              is_pixel(found, i, pixel_if(in, i, is_within(in, i, limit))))) {
        i++;
    }
    return i == ROW_PIXELS;
}

// Each pixel is right, but for numbers that are no mask.
static int is_right_without_mask(const CircleRowJob *in, const CircleRowAnswer *found)
{
    int i = 0;
    while (i < ROW_PIXELS && found->colors[i] == right(in, i).color &&
           (found->open[i] == right(in, i).open || (found->open[i] != 0 && found->open[i] != -1))) {
        i++;
    }
    return i == ROW_PIXELS;
}

// How far apart two squares may be, as a part of them, whose roots are the same to a device: each
// root may be off by 3 units in its last place (OpenCL), and by as much again in the other one.
#define ROOTS_HAIR (12 * (double)FLT_EPSILON)
// As much as somebody may add to the square of a radius.
#define LARGEST_EPSILON 0.01

KNOWN_LIST(known)
{
    GIVEN;
    const double dy = in->dy, r2 = in->radius_squared;
    int is_row = 1;

    COVERS(strict, dx2 + dy * dy < r2,
           "strict where it should not be: the boundary belongs to the circle",
           MISTAKE_STRICT_BOUNDARY);
    COVERS(without_dy, dx2 <= r2, "that is as if dy were 0: the distance has two parts");
    COVERS(dy_itself, dx2 + dy <= r2, DY_NOT_SQUARED);
    COVERS(dy_size, dx2 + fabs(dy) <= r2, DY_NOT_SQUARED);
    COVERS(whole_dy, dx2 + trunc(dy) * trunc(dy) <= r2, "dy was cut to a whole number");
    COVERS(radius_again, dx2 + dy * dy <= r2 * r2,
           "that is as if the radius were squared twice: radius_squared is its square already, and "
           "compared with a square, not with a distance");
    COVERS(dx_again, (dx2 * dx2 + dy * dy <= r2),
           "dx is squared twice: dx_squared is its square already");
    COVERS(subtracted, dx2 - dy * dy <= r2, "the square of dy is taken off: the squares add up");
    COVERS(inverted, !is_covered,
           "what the circle does not cover is painted, and what it covers is not");
    COVERS(all_or_none, n_covered(in) > 0,
           "that is as if one pixel decided for the whole row: each lane has an answer of its own");
    COVERS(without_first, is_covered && 0 < k, "the row's first pixel is left out");
    COVERS(without_last, k < ROW_PIXELS - 1 && is_covered, "the row's last pixel is left out");
    COVERS(point_left, is_covered && r2 > 0,
           "a circle of radius 0 is left out: it covers the pixel that it is exactly on");
    COVERS(part_left, n_open(in) == ROW_PIXELS && is_covered,
           "a row that is painted in part has open pixels, too");

    // By what is painted.
    PIXELS(painted_over, ((Pixel){is_covered ? in->color : color, expected.open}),
           "a pixel that a nearer circle covers was painted again: only what is open may be");
    PIXELS(black_is_open, ((Pixel){(is_covered && color == 0) ? in->color : color, expected.open}),
           "that is as if a colour of 0 said that a pixel is open: a circle may be black");
    PIXELS(nothing_painted, ((Pixel){color, expected.open}),
           "what is covered is closed, and was not painted before");
    PIXELS(select_swapped, ((Pixel){(!(is_covered && open)) ? in->color : color, expected.open}),
           "select(a, b, c) takes b where c is -1: the old colours and the circle's stand in each "
           "other's place");
    PIXELS(erases, ((Pixel){is_covered && open ? in->color : 0, expected.open}),
           "what the circle does not cover lost its colour: it stays as it was");
    STAYS(stays_open, open,
          "a pixel that is painted stays open: the next circle would paint it again");
    STAYS(touched_stays, r2 != dy * dy && is_covered ? 0 : open,
          "where the circle only touches the row, as far away as its radius, the pixel that it "
          "covers is closed, too");
    STAYS(closed_outside, is_covered ? open : 0,
          "the wrong pixels stay open: what the circle covers is closed, what it does not cover "
          "stays as it was");
    STAYS(closed_whole, n_covered(in) > 0 ? 0 : open,
          "the whole row is closed: pixels that the circle does not cover stay as they were");
    STAYS(covered_alone, is_covered ? 0 : -1, OPENS_AGAIN);
    STAYS(turned_round, is_covered ? ~open : open, OPENS_AGAIN);

    EACH(no_mask, is_right_without_mask(in, found),
         "an `open` is neither -1 nor 0: for lanes these are true and false");
    EACH(roots, is_covered_within(in, found, r2 * (1 + ROOTS_HAIR)),
         "compare the squares, and without an epsilon: roots round a pixel beside the circle onto "
         "its boundary");
    ONLY(epsilon, is_covered_within(in, found, r2 + LARGEST_EPSILON),
         "only pixels a little outside of the circle are wrong: compare without an epsilon");
    return NO_MORE;
}

// ---- Answers ------------------------------------------------------------------------------------

static char *describe(const void *job, int i, const void *answers)
{
    GIVEN;
    const int at = first_wrong(in, found);
    const Pixel expected = right(in, at);
    return message_new("pixel %d of a row, dx_squared %.9g, dy %.9g, radius_squared %.9g, open %d: "
                       "found %s, open %d, expected %s, open %d (before: %s; the circle: %s)",
                       at, in->dx_squared[at], in->dy, in->radius_squared, in->open[at],
                       words_rgba(found->colors[at]).text, found->open[at],
                       words_rgba(expected.color).text, expected.open,
                       words_rgba(in->colors[at]).text, words_rgba(in->color).text);
}

const Function circle_row_10 = {"circle_rows",           N_ROWS_10,
                                sizeof(CircleRowAnswer), KNOWING(is_right, describe, known),
                                .counted = "rows",       .is_known_by_range = 1};
