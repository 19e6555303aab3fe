// Lab 10's paint_row: its inputs, and what must come out. Distances are on the grid of 1/16 px,
// large ones on that of 1/2 px, so that every comparison is exact; or off the grid, and then no
// pixel is so near to the boundary that rounding decides. An answer is right or wrong to the bit.
#include "judge_10.h"

#include "message.h"
#include "random3d.h"

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

// Does float decide as double does for each pixel, whichever way it rounds? There are three
// operations, and at most 2^-24 of the sum comes from each.
static int is_decided(const CircleRowJob *job)
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
    } while (!is_decided(&job));
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

// ---- Judging ----------------------------------------------------------------------------------

enum {
    ROW_STRICT = 1,
    ROW_WITHOUT_DY,
    ROW_DY_NOT_SQUARED,
    ROW_RADIUS_SQUARED_AGAIN,
    ROW_INVERTED,
    ROW_PAINTED_OVER,
    ROW_STAYS_OPEN,
    ROW_TOUCHED_STAYS_OPEN,
    ROW_CLOSED_OUTSIDE,
    ROW_CLOSED_WHOLE,
    ROW_ALL_OR_NONE,
    ROW_BLACK_IS_OPEN,
    ROW_COVERED_ALL_CLOSED,
    ROW_TURNED_ROUND,
    ROW_NOTHING_PAINTED,
    ROW_SELECT_SWAPPED,
    ROW_PART_LEFT,
    ROW_WHOLE_DY,
    ROW_DY_SIZE,
    ROW_WITHOUT_FIRST,
    ROW_WITHOUT_LAST,
    ROW_ROOTS,
    ROW_POINT_LEFT,
    ROW_EPSILON,
    ROW_ERASES,
    ROW_OPEN_IS_NO_MASK,
    ROW_DX_SQUARED_AGAIN,
    ROW_SUBTRACTED,
};
#define OPENS_AGAIN "what was closed already is open again: a pixel never opens"
#define DY_NOT_SQUARED                                                                             \
    "that is as if dy were added as it is: dx_squared is squared already, dy is not"

static const Cause row_mistakes[] = {
    [ROW_STRICT] = {"strict where it should not be: the boundary belongs to the circle",
                    MISTAKE_STRICT_BOUNDARY},
    [ROW_WITHOUT_DY] = {.says = "that is as if dy were 0: the distance has two parts"},
    [ROW_DY_NOT_SQUARED] = {.says = DY_NOT_SQUARED},
    [ROW_DY_SIZE] = {.says = DY_NOT_SQUARED},
    [ROW_WHOLE_DY] = {.says = "dy was cut to a whole number"},
    [ROW_RADIUS_SQUARED_AGAIN] = {.says = "that is as if the radius were squared twice: "
                                          "radius_squared is its square already, and compared "
                                          "with a square, not with a distance"},
    [ROW_INVERTED] = {.says = "what the circle does not cover is painted, and what it covers is "
                              "not"},
    [ROW_PAINTED_OVER] = {.says = "a pixel that a nearer circle covers was painted again: only "
                                  "what is open may be"},
    [ROW_STAYS_OPEN] = {.says = "a pixel that is painted stays open: the next circle would paint "
                                "it again"},
    [ROW_TOUCHED_STAYS_OPEN] = {.says = "where the circle only touches the row, as far away as its "
                                        "radius, the pixel that it covers is closed, too"},
    [ROW_CLOSED_OUTSIDE] = {.says = "the wrong pixels stay open: what the circle covers is closed, "
                                    "what it does not cover stays as it was"},
    [ROW_CLOSED_WHOLE] = {.says = "the whole row is closed: pixels that the circle does not cover "
                                  "stay as they were"},
    [ROW_ALL_OR_NONE] = {.says = "that is as if one pixel decided for the whole row: each lane has "
                                 "an answer of its own"},
    [ROW_BLACK_IS_OPEN] = {.says = "that is as if a colour of 0 said that a pixel is open: a "
                                   "circle may be black"},
    [ROW_COVERED_ALL_CLOSED] = {.says = OPENS_AGAIN},
    [ROW_TURNED_ROUND] = {.says = OPENS_AGAIN},
    [ROW_NOTHING_PAINTED] = {.says = "what is covered is closed, and was not painted before"},
    [ROW_SELECT_SWAPPED] = {.says = "select(a, b, c) takes b where c is -1: the old colours and "
                                    "the circle's stand in each other's place"},
    [ROW_PART_LEFT] = {.says = "a row that is painted in part has open pixels, too"},
    [ROW_WITHOUT_FIRST] = {.says = "the row's first pixel is left out"},
    [ROW_WITHOUT_LAST] = {.says = "the row's last pixel is left out"},
    [ROW_ROOTS] = {.says = "compare the squares, and without an epsilon: roots round a pixel "
                           "beside the circle onto its boundary"},
    [ROW_ERASES] = {.says = "what the circle does not cover lost its colour: it stays as it was"},
    [ROW_OPEN_IS_NO_MASK] = {.says = "an `open` is neither -1 nor 0: for lanes these are true and "
                                     "false"},
    [ROW_DX_SQUARED_AGAIN] = {.says = "dx is squared twice: dx_squared is its square already"},
    [ROW_SUBTRACTED] = {.says = "the square of dy is taken off: the squares add up"},
    [ROW_POINT_LEFT] = {.says = "a circle of radius 0 is left out: it covers the pixel that it is "
                                "exactly on"},
    [ROW_EPSILON] = {.says =
                         "only pixels a little outside of the circle are wrong: compare without "
                         "an epsilon"},
};

// How far apart two squares may be, as a part of them, whose roots are the same to a device: each
// root may be off by 3 units in its last place (OpenCL), and by as much again in the other one.
#define ROOTS_HAIR (12 * (double)FLT_EPSILON)
// As much as somebody may add to the square of a radius.
#define LARGEST_EPSILON 0.01

static int is_covered(const CircleRowJob *job, int i, int mistake)
{
    const double dy = mistake == ROW_WHOLE_DY ? trunc(job->dy) : job->dy;
    const double dy_part = mistake == ROW_WITHOUT_DY       ? 0
                           : mistake == ROW_DY_NOT_SQUARED ? dy
                           : mistake == ROW_DY_SIZE        ? fabs(dy)
                                                           : dy * dy;
    const double dx_part = mistake == ROW_DX_SQUARED_AGAIN
                               ? (double)job->dx_squared[i] * (double)job->dx_squared[i]
                               : (double)job->dx_squared[i];
    const double distance = mistake == ROW_SUBTRACTED ? dx_part - dy_part : dx_part + dy_part;
    const double r = job->radius_squared;
    const double limit = mistake == ROW_RADIUS_SQUARED_AGAIN ? r * r : r;
    const int covers = mistake == ROW_STRICT ? distance < limit : distance <= limit;
    if ((mistake == ROW_WITHOUT_FIRST && i == 0) ||
        (mistake == ROW_WITHOUT_LAST && i == ROW_PIXELS - 1) ||
        (mistake == ROW_POINT_LEFT && r == 0)) {
        return 0;
    }
    if (mistake == ROW_ROOTS) {
        return distance <= r * (1 + ROOTS_HAIR);
    }
    if (mistake == ROW_EPSILON) {
        return distance <= r + LARGEST_EPSILON;
    }
    return mistake == ROW_INVERTED ? !covers : covers;
}

static CircleRowAnswer expected_row(const CircleRowJob *job, int mistake)
{
    CircleRowAnswer row;
    int n_covered = 0, n_open = 0;
    for (int i = 0; i < ROW_PIXELS; i++) {
        n_covered += is_covered(job, i, mistake);
        n_open += job->open[i] != 0;
    }
    const int is_touched = (double)job->dy * (double)job->dy == (double)job->radius_squared;
    const int is_left = mistake == ROW_PART_LEFT && n_open < ROW_PIXELS;
    for (int i = 0; i < ROW_PIXELS; i++) {
        const int covers = is_left                      ? 0
                           : mistake == ROW_ALL_OR_NONE ? n_covered > 0
                                                        : is_covered(job, i, mistake);
        const int was_open = mistake == ROW_PAINTED_OVER    ? 1
                             : mistake == ROW_BLACK_IS_OPEN ? job->colors[i] == 0
                                                            : job->open[i] != 0;
        const int is_painted =
            mistake == ROW_SELECT_SWAPPED ? !(covers && was_open) : covers && was_open;
        row.colors[i] = is_painted && mistake != ROW_NOTHING_PAINTED ? job->color
                        : mistake == ROW_ERASES                      ? 0
                                                                     : job->colors[i];
        row.open[i] = mistake == ROW_STAYS_OPEN ? job->open[i]
                      : mistake == ROW_TOUCHED_STAYS_OPEN
                          ? (is_touched || !covers ? job->open[i] : 0)
                      : mistake == ROW_CLOSED_OUTSIDE     ? (covers ? job->open[i] : 0)
                      : mistake == ROW_CLOSED_WHOLE       ? (n_covered > 0 ? 0 : job->open[i])
                      : mistake == ROW_COVERED_ALL_CLOSED ? (covers ? 0 : -1)
                      : mistake == ROW_TURNED_ROUND       ? (covers ? ~job->open[i] : job->open[i])
                      : covers                            ? 0
                                                          : job->open[i];
    }
    return row;
}

static int same_pixel(const CircleRowAnswer *found, const CircleRowAnswer *expected, int i)
{
    return found->colors[i] == expected->colors[i] && found->open[i] == expected->open[i];
}

// The first pixel in which an answer differs, or ROW_PIXELS.
static int first_difference(const CircleRowAnswer *found, const CircleRowAnswer *expected)
{
    int i = 0;
    while (i < ROW_PIXELS && same_pixel(found, expected, i)) {
        i++;
    }
    return i;
}

// A device's roots may part two squares that are a hair from each other, or not, and an epsilon may
// be smaller than the largest: either agrees.
static int agrees_in_part(const CircleRowJob *job, const CircleRowAnswer *found, int mistake)
{
    const CircleRowAnswer mistaken = expected_row(job, mistake), right = expected_row(job, 0);
    int i = 0;
    while (i < ROW_PIXELS && (same_pixel(found, &mistaken, i) || same_pixel(found, &right, i))) {
        i++;
    }
    return i == ROW_PIXELS;
}

// Colours are right, and so is what is open, but for numbers that are no mask.
static int agrees_without_mask(const CircleRowJob *job, const CircleRowAnswer *found)
{
    const CircleRowAnswer right = expected_row(job, 0);
    int i = 0;
    while (i < ROW_PIXELS && found->colors[i] == right.colors[i] &&
           (found->open[i] == right.open[i] || (found->open[i] != 0 && found->open[i] != -1))) {
        i++;
    }
    return i == ROW_PIXELS;
}

static int row_agrees(const void *job, int i, const void *answers, int mistake)
{
    const CircleRowJob *row = &((const Job10 *)job)->rows[i];
    const CircleRowAnswer *found = (const CircleRowAnswer *)answers + i;
    if (mistake == ROW_ROOTS || mistake == ROW_EPSILON) {
        return agrees_in_part(row, found, mistake);
    }
    if (mistake == ROW_OPEN_IS_NO_MASK) {
        return agrees_without_mask(row, found);
    }
    const CircleRowAnswer expected = expected_row(row, mistake);
    return first_difference(found, &expected) == ROW_PIXELS;
}

static char *describe_row(const void *pointer, int i, const void *answers)
{
    const CircleRowJob *job = &((const Job10 *)pointer)->rows[i];
    const CircleRowAnswer *found = (const CircleRowAnswer *)answers + i;
    const CircleRowAnswer expected = expected_row(job, 0);
    const int at = first_difference(found, &expected);
    return message_new("pixel %d of a row, dx_squared %.9g, dy %.9g, radius_squared %.9g, open %d: "
                       "found colour %08x and open %d, expected %08x and %d (before: %08x; the "
                       "circle's: %08x)",
                       at, job->dx_squared[at], job->dy, job->radius_squared, job->open[at],
                       found->colors[at], found->open[at], expected.colors[at], expected.open[at],
                       job->colors[at], job->color);
}

const Function circle_row_10 = {"circle_rows", N_ROWS_10, sizeof(CircleRowAnswer),
                                COMPARED(row_agrees, describe_row, row_mistakes),
                                .counted = "rows"};
