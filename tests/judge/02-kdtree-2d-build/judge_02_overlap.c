// Lab 02: circle_overlaps_box on the job's inputs. See judge_02.h.
#include "judge_02.h"

#include "message.h"
#include "oracle2d.h"
#include "overlap_cause.h"
#include "words.h"

#include <math.h>

// ---- Rivals -------------------------------------------------------------------------------------

// What a known mistake answers to any input, in double.

static double squared(double value)
{
    return value * value;
}

static int covers(Circle circle, double x, double y)
{
    return squared(circle.x - x) + squared(circle.y - y) <= squared(circle.radius);
}

static int holds_centre(BoxOverlapJob in)
{
    return in.circle.x >= in.box.minX && in.circle.x <= in.box.maxX && in.circle.y >= in.box.minY &&
           in.circle.y <= in.box.maxY;
}

static int holds_centre_half_open(BoxOverlapJob in)
{
    return in.circle.x >= in.box.minX && in.circle.x < in.box.maxX && in.circle.y >= in.box.minY &&
           in.circle.y < in.box.maxY;
}

// So do distances squared that are negative within the cell's width and height.
static int covers_corner(BoxOverlapJob in)
{
    const Circle c = in.circle;
    const BBox2D box = in.box;
    return covers(c, box.minX, box.minY) || covers(c, box.minX, box.maxY) ||
           covers(c, box.maxX, box.minY) || covers(c, box.maxX, box.maxY);
}

static int covers_corner_or_is_held(BoxOverlapJob in)
{
    return covers_corner(in) || holds_centre(in);
}

static int has_point_in_common(BoxOverlapJob in)
{
    const double x = in.circle.x, y = in.circle.y, r = in.circle.radius;
    const double tips[][2] = {{x - r, y}, {x + r, y}, {x, y - r}, {x, y + r}};
    int is_held = covers_corner_or_is_held(in);
    for (int i = 0; i < COUNT(tips); i++) {
        is_held |= tips[i][0] >= in.box.minX && tips[i][0] <= in.box.maxX &&
                   tips[i][1] >= in.box.minY && tips[i][1] <= in.box.maxY;
    }
    return is_held;
}

static int covers_middle(BoxOverlapJob in)
{
    return covers(in.circle, ((double)in.box.minX + in.box.maxX) / 2,
                  ((double)in.box.minY + in.box.maxY) / 2);
}

// The border, and not what is within it.
static int reaches_border(BoxOverlapJob in)
{
    const double to_x =
        fmin(fabs((double)in.circle.x - in.box.minX), fabs((double)in.circle.x - in.box.maxX));
    const double to_y =
        fmin(fabs((double)in.circle.y - in.box.minY), fabs((double)in.circle.y - in.box.maxY));
    return holds_centre(in) ? fmin(to_x, to_y) <= in.circle.radius
                            : oracle2d_overlaps_box(in.circle, in.box);
}

static double clamped(double value, double low, double high)
{
    return fmin(fmax(value, low), high);
}

static int clamps_the_wrong_way(BoxOverlapJob in)
{
    return covers(in.circle, fmin(in.box.minX, fmax(in.circle.x, in.box.maxX)),
                  fmin(in.box.minY, fmax(in.circle.y, in.box.maxY)));
}

static int clamps_y_by_maxX(BoxOverlapJob in)
{
    return covers(in.circle, clamped(in.circle.x, in.box.minX, in.box.maxX),
                  clamped(in.circle.y, in.box.minY, in.box.maxX));
}

static int clamps_y_by_x(BoxOverlapJob in)
{
    return covers(in.circle, clamped(in.circle.x, in.box.minX, in.box.maxX),
                  clamped(in.circle.y, in.box.minX, in.box.maxX));
}

static int clamps_x_by_y(BoxOverlapJob in)
{
    return covers(in.circle, clamped(in.circle.x, in.box.minY, in.box.maxY),
                  clamped(in.circle.y, in.box.minY, in.box.maxY));
}

static int meets_circle_around(BoxOverlapJob in)
{
    const double x = ((double)in.box.minX + in.box.maxX) / 2;
    const double y = ((double)in.box.minY + in.box.maxY) / 2;
    const double half = sqrt(squared(in.box.maxX - x) + squared(in.box.maxY - y));
    return sqrt(squared(in.circle.x - x) + squared(in.circle.y - y)) <= in.circle.radius + half;
}

static int squares_one_side(BoxOverlapJob in)
{
    const double dx = in.circle.x - clamped(in.circle.x, in.box.minX, in.box.maxX);
    const double dy = in.circle.y - clamped(in.circle.y, in.box.minY, in.box.maxY);
    return squared(dx) + squared(dy) <= in.circle.radius;
}

#define OTHER_AXIS "your answers are those of one axis clamped by a border of the other"
#define BY_CENTRE "your answers are those of the centre alone: a circle has a radius"
static const struct {
    int (*answer)(BoxOverlapJob in);
    const char *says;
} overlap_rivals[] = {
    {holds_centre, BY_CENTRE},
    {holds_centre_half_open, BY_CENTRE},
    {covers_corner,
     "your answers are those of the cell's corners alone: within its width the distance is 0"},
    {covers_corner_or_is_held,
     "your answers are those of corners and centre: a circle may reach over one side only"},
    {has_point_in_common,
     "your answers are those of corners, centre and tips: any other point may be the nearest"},
    {covers_middle, "your answers are those of the cell's middle, and another point may be nearer"},
    {reaches_border, "a circle within the cell, far from its border, overlaps it all the same"},
    {clamps_the_wrong_way, "your answers are those of fmin and fmax in each other's places"},
    {clamps_y_by_maxX, OTHER_AXIS},
    {clamps_y_by_x, OTHER_AXIS},
    {clamps_x_by_y, OTHER_AXIS},
    {meets_circle_around, "your answers are those of a circle around the cell"},
    {squares_one_side, "your answers are those of distance² <= radius, without its square"},
};

static int is_overlap_rival(const Job02 *job, const i32 *found, int rival)
{
    int i = 0;
    while (i < N_OVERLAPS && (found[i] != 0) == overlap_rivals[rival].answer(job->overlaps[i])) {
        i++;
    }
    return i == N_OVERLAPS;
}

// ---- Judging ------------------------------------------------------------------------------------

// As overlap_cause.h has it.
static Reach reach_of(const void *job, int i)
{
    const BoxOverlapJob in = ((const Job02 *)job)->overlaps[i];
    return (Reach){{outside_of(in.circle.x, in.box.minX, in.box.maxX),
                    outside_of(in.circle.y, in.box.minY, in.box.maxY)},
                   in.circle.radius};
}

static Cause explain_overlap(const Job02 *job, int i, const i32 *found)
{
    for (int m = 0; m < COUNT(overlap_rivals); m++) {
        if (is_overlap_rival(job, found, m)) {
            return (Cause){.says = overlap_rivals[m].says};
        }
    }
    if (found[i] != 0 && found[i] != 1 &&
        oracle2d_overlaps_box(job->overlaps[i].circle, job->overlaps[i].box)) {
        return (Cause){.says = JUST_1_AND_0};
    }
    const Cause cause = overlap_cause(reach_of, job, N_OVERLAPS, found);
    if (cause.says == NULL && found[i] && overlap_is_of_box(reach_of, job, N_OVERLAPS, found)) {
        return (Cause){.says = "the circle's bounding square overlaps, the circle does not"};
    }
    return cause;
}

static Diagnosis overlap_fault(const void *pointer, int i, const void *answers)
{
    const Job02 *job = pointer;
    const BoxOverlapJob in = job->overlaps[i];
    const i32 *found = answers;
    const int expected = oracle2d_overlaps_box(in.circle, in.box);
    return found[i] == expected
               ? NOTHING_WRONG
               : diagnosis_of(message_new("circle at %s, box %s: found %d, expected %d",
                                          words_circle(in.circle).text, words_box2d(in.box).text,
                                          found[i], expected),
                              explain_overlap(job, i, found));
}

const Function overlap_02 = {"overlaps", N_OVERLAPS, sizeof(i32), .fault = overlap_fault};
