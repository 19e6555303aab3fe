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

#define DX ((double)in->dx_squared[i])
#define DY ((double)in->dy)
#define R ((double)in->radius_squared)
#define IS_COVERED (DX + DY * DY <= R)

static Pixel right(const CircleRowJob *in, int i)
{
    return pixel_if(in, i, IS_COVERED);
}

// The first pixel of a row that is another one, or ROW_PIXELS.
typedef Pixel PixelOf(const CircleRowJob *in, int i);
static int first_other(const CircleRowJob *in, const CircleRowAnswer *found, PixelOf *expected)
{
    int i = 0;
    while (i < ROW_PIXELS && found->colors[i] == expected(in, i).color &&
           found->open[i] == expected(in, i).open) {
        i++;
    }
    return i;
}

#define IS_FOUND(pixel) (first_other(in, found, pixel) == ROW_PIXELS)

RIGHT(is_right, IS_FOUND(right))

// ---- Mistakes -----------------------------------------------------------------------------------

#define PIXELS(name, pixel, ...)                                                                   \
    static Pixel name##_pixel(const CircleRowJob *in, int i)                                       \
    {                                                                                              \
        return pixel;                                                                              \
    }                                                                                              \
    ANSWERS(name, name##_pixel, __VA_ARGS__)

// By what is covered.
#define COVERS(name, is_covered, ...) PIXELS(name, pixel_if(in, i, is_covered), __VA_ARGS__)
#define DY_NOT_SQUARED                                                                             \
    "that is as if dy were added as it is: dx_squared is squared already, dy is not"

static int n_covered(const CircleRowJob *in)
{
    int n = 0;
    for (int i = 0; i < ROW_PIXELS; i++) {
        n += IS_COVERED;
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

COVERS(strict, DX + DY * DY < R,
       "strict where it should not be: the boundary belongs to the circle", MISTAKE_STRICT_BOUNDARY)
COVERS(without_dy, DX <= R, "that is as if dy were 0: the distance has two parts")
COVERS(dy_itself, DX + DY <= R, DY_NOT_SQUARED)
COVERS(dy_size, DX + fabs(DY) <= R, DY_NOT_SQUARED)
COVERS(whole_dy, DX + trunc(DY) * trunc(DY) <= R, "dy was cut to a whole number")
COVERS(radius_again, DX + DY * DY <= R * R,
       "that is as if the radius were squared twice: radius_squared is its square already, and "
       "compared with a square, not with a distance")
COVERS(dx_again, (DX * DX + DY * DY <= R), "dx is squared twice: dx_squared is its square already")
COVERS(subtracted, DX - DY * DY <= R, "the square of dy is taken off: the squares add up")
COVERS(inverted, !IS_COVERED,
       "what the circle does not cover is painted, and what it covers is not")
COVERS(all_or_none, n_covered(in) > 0,
       "that is as if one pixel decided for the whole row: each lane has an answer of its own")
COVERS(without_first, IS_COVERED && 0 < i, "the row's first pixel is left out")
COVERS(without_last, i < ROW_PIXELS - 1 && IS_COVERED, "the row's last pixel is left out")
COVERS(point_left, IS_COVERED &&R > 0,
       "a circle of radius 0 is left out: it covers the pixel that it is exactly on")
COVERS(part_left, n_open(in) == ROW_PIXELS && IS_COVERED,
       "a row that is painted in part has open pixels, too")

// By what is painted.
#define PAINTED_IF(is_painted) ((is_painted) ? in->color : in->colors[i])
PIXELS(painted_over, ((Pixel){PAINTED_IF(IS_COVERED), right(in, i).open}),
       "a pixel that a nearer circle covers was painted again: only what is open may be")
PIXELS(black_is_open, ((Pixel){PAINTED_IF(IS_COVERED && in->colors[i] == 0), right(in, i).open}),
       "that is as if a colour of 0 said that a pixel is open: a circle may be black")
PIXELS(nothing_painted, ((Pixel){in->colors[i], right(in, i).open}),
       "what is covered is closed, and was not painted before")
PIXELS(select_swapped, ((Pixel){PAINTED_IF(!(IS_COVERED && in->open[i])), right(in, i).open}),
       "select(a, b, c) takes b where c is -1: the old colours and the circle's stand in each "
       "other's place")
PIXELS(erases, ((Pixel){IS_COVERED && in->open[i] ? in->color : 0, right(in, i).open}),
       "what the circle does not cover lost its colour: it stays as it was")

// By what stays open.
#define OPENS_AGAIN "what was closed already is open again: a pixel never opens"
#define STAYS(name, is_open, ...) PIXELS(name, ((Pixel){right(in, i).color, is_open}), __VA_ARGS__)
STAYS(stays_open, in->open[i],
      "a pixel that is painted stays open: the next circle would paint it again")
STAYS(touched_stays, R != DY * DY && IS_COVERED ? 0 : in->open[i],
      "where the circle only touches the row, as far away as its radius, the pixel that it covers "
      "is closed, too")
STAYS(closed_outside, IS_COVERED ? in->open[i] : 0,
      "the wrong pixels stay open: what the circle covers is closed, what it does not cover stays "
      "as it was")
STAYS(closed_whole, n_covered(in) > 0 ? 0 : in->open[i],
      "the whole row is closed: pixels that the circle does not cover stay as they were")
STAYS(covered_alone, IS_COVERED ? 0 : -1, OPENS_AGAIN)
STAYS(turned_round, IS_COVERED ? ~in->open[i] : in->open[i], OPENS_AGAIN)

// Each pixel is right, or is covered by so much too little.
static int is_covered_within(const CircleRowJob *in, const CircleRowAnswer *found, double limit)
{
    int i = 0, is_so = 1;
    for (; i < ROW_PIXELS && is_so; i++) {
        const Pixel pixels[2] = {right(in, i), pixel_if(in, i, DX + DY * DY <= limit)};
        is_so = (found->colors[i] == pixels[0].color && found->open[i] == pixels[0].open) ||
                (found->colors[i] == pixels[1].color && found->open[i] == pixels[1].open);
    }
    return is_so;
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

EACH(no_mask, is_right_without_mask(in, found),
     "an `open` is neither -1 nor 0: for lanes these are true and false")

// How far apart two squares may be, as a part of them, whose roots are the same to a device: each
// root may be off by 3 units in its last place (OpenCL), and by as much again in the other one.
#define ROOTS_HAIR (12 * (double)FLT_EPSILON)
EACH(roots, is_covered_within(in, found, R * (1 + ROOTS_HAIR)),
     "compare the squares, and without an epsilon: roots round a pixel beside the circle onto its "
     "boundary")
// As much as somebody may add to the square of a radius.
#define LARGEST_EPSILON 0.01
ONLY(epsilon, is_covered_within(in, found, R + LARGEST_EPSILON),
     "only pixels a little outside of the circle are wrong: compare without an epsilon")

static const Known *const known[] = {
    &strict,       &without_dy, &dy_itself,     &dy_size,        &whole_dy,        &radius_again,
    &dx_again,     &subtracted, &inverted,      &all_or_none,    &without_first,   &without_last,
    &point_left,   &part_left,  &painted_over,  &black_is_open,  &nothing_painted, &select_swapped,
    &erases,       &stays_open, &touched_stays, &closed_outside, &closed_whole,    &covered_alone,
    &turned_round, &no_mask,    &roots,         &epsilon};

// ---- Answers ------------------------------------------------------------------------------------

static char *describe(const void *job, int i, const void *answers)
{
    GIVEN;
    const int at = first_other(in, found, right);
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
