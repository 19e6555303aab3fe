// Lab 01: overlaps_N_Nearer on chosen inputs (judge_01_inputs.c): what is right, and which mistakes
// are known.
#include "judge_01.h"

#include "message.h"
#include "oracle2d.h"
#include "words.h"

#include <math.h>

#define GIVEN                                                                                      \
    const OverlapJob in = ((const Job01 *)job)->overlaps[i];                                       \
    const int found = ((const i32 *)answers)[i]
#define IS_FOUND(expected) (found == (expected))

// ---- Right --------------------------------------------------------------------------------------

// The answer for a sample point.
static int covers(OverlapJob in, double x, double y)
{
    return oracle2d_covers(in.circle, x, y) && in.circle.depth < in.minDepth;
}

static int overlaps(OverlapJob in)
{
    return covers(in, in.x, in.y);
}

RIGHT(is_right, IS_FOUND(overlaps(in)))

// ---- Mistakes -----------------------------------------------------------------------------------

#define HALF_A_PIXEL                                                                               \
    "shifted by half a pixel: the sample point is the integer coordinate", MISTAKE_SHIFTED_HALF

#define HALF_ACROSS                                                                                \
    "shifted by half a pixel in one direction: the sample point is the integer coordinate in "     \
    "both",                                                                                        \
        MISTAKE_SHIFTED_HALF

// With other distances from the centre, in other relations to the radius.
static int is_within(OverlapJob in, double distance, double radius)
{
    return distance <= radius && in.circle.depth < in.minDepth;
}

static double squared(double value)
{
    return value * value;
}

static double to_x(OverlapJob in)
{
    return fabs(in.x - (double)in.circle.x);
}

static double to_y(OverlapJob in)
{
    return fabs(in.y - (double)in.circle.y);
}

static float float_root(OverlapJob in)
{
    const float dx = (float)in.x - in.circle.x, dy = (float)in.y - in.circle.y;
    return sqrtf(dx * dx + dy * dy);
}

// With another distance² or radius². Where the student's rounding decides, either answer fits.
static int is_of(OverlapJob in, int found, double distance2, double radius2)
{
    const int is_nearer = in.circle.depth < in.minDepth;
    return found == (distance2 <= radius2 && is_nearer) ||
           (is_nearer && fabs(distance2 - radius2) <= 1e-6 * radius2);
}

#define COMPARES(name, distance2, radius2, ...)                                                    \
    EACH(name, is_of(in, found, distance2, radius2), __VA_ARGS__)
#define DISTANCE2(name, expression, ...) COMPARES(name, expression, squared(radius), __VA_ARGS__)
#define DIFFERENCES(name, x, y, ...) DISTANCE2(name, squared(x) + squared(y), __VA_ARGS__)

// With other depths.
static int covers_with_depths(OverlapJob in, float depth, float min_depth)
{
    return depth < min_depth && oracle2d_covers(in.circle, in.x, in.y);
}

// By so little that a root which is rounded to float, by up to 3 ulp (OpenCL 1.2, 7.4), may be the
// reason, on whatever device.
#define ROOTS_ERROR (16 * 0x1p-24)

// On the boundary that may as well be an epsilon: it comes last.
#define WHOLE_NUMBERS                                                                              \
    "your answers are those of whole-numbered distances: a centre lies between pixels"

static OverlapJob around_whole_centre(OverlapJob in)
{
    in.circle.x = truncf(in.circle.x);
    in.circle.y = truncf(in.circle.y);
    return in;
}

KNOWN_LIST(known)
{
    GIVEN;
    const double radius = in.circle.radius;
    const double distance2 = squared(to_x(in)) + squared(to_y(in));
    const double dx = (double)in.x - in.circle.x;
    const double dy = (double)in.y - in.circle.y;
    const double sum_x = (double)in.x + in.circle.x;
    const double sum_y = (double)in.y + in.circle.y;
    const double x_to_y = (double)in.x - in.circle.y;
    const double y_to_x = (double)in.y - in.circle.x;
    const int covers_it = oracle2d_covers(in.circle, in.x, in.y);
    const int is_nearer = in.circle.depth < in.minDepth;
    const int overflows = fmax(to_x(in), to_y(in)) > 32767;

    ANSWERS(from_middle, covers(in, in.x + 0.5, in.y + 0.5), HALF_A_PIXEL);
    ANSWERS(from_corner, covers(in, in.x - 0.5, in.y - 0.5), HALF_A_PIXEL);

    ANSWERS(from_right, covers(in, in.x + 0.5, in.y), HALF_ACROSS);
    ANSWERS(from_left, covers(in, in.x - 0.5, in.y), HALF_ACROSS);
    ANSWERS(from_below, covers(in, in.x, in.y + 0.5), HALF_ACROSS);
    ANSWERS(from_above, covers(in, in.x, in.y - 0.5), HALF_ACROSS);

#define ONE_PIXEL "shifted by one pixel: columns and rows count from 0", MISTAKE_SHIFTED_ONE
    ANSWERS(one_on, covers(in, in.x + 1, in.y + 1), ONE_PIXEL);
    ANSWERS(one_right, covers(in, in.x + 1, in.y), ONE_PIXEL);
    ANSWERS(one_down, covers(in, in.x, in.y + 1), ONE_PIXEL);

    ANSWERS(square, is_within(in, fmax(to_x(in), to_y(in)), in.circle.radius),
            "the pixel is in the circle's bounding square but not in the circle");
    ANSWERS(open_square,
            fmax(to_x(in), to_y(in)) < in.circle.radius && in.circle.depth < in.minDepth,
            "the pixel is in the circle's bounding square but not in the circle");
    ANSWERS(diamond, is_within(in, to_x(in) + to_y(in), in.circle.radius),
            "your answers are those of |dx| + |dy|, and the distance² is dx² + dy²");
    ANSWERS(by_root, is_within(in, float_root(in), in.circle.radius),
            "your answers are those of a root, which is rounded: compare the squares");

    COMPARES(radius_unsquared, distance2, radius,
             "your answers are those of distance² <= radius, without its square");
    COMPARES(distance_rooted, sqrt(distance2), squared(radius),
             "your answers are those of distance <= radius²: compare the squares of both");
    COMPARES(half_radius, distance2, squared(radius / 2),
             "your answers are those of half the radius");
    COMPARES(twice_radius, distance2, squared(2 * radius),
             "your answers are those of twice the radius");
    COMPARES(two_radii, distance2, 2 * radius,
             "your answers are those of 2 * radius: its square is radius * radius");
    EACH(whole_radius, radius > 32767 || is_of(in, found, distance2, squared(trunc(radius))),
         "your answers are those of a radius that was made a whole number");

#define SUBTRACTED "your answers are those of dx² - dy²: the squares are added"
#define MIXED_AXES "x and y are mixed up in a difference: dx takes both x, and dy takes both y"
#define ADDED "your answers are those of pixel plus centre: dx and dy are differences"
#define ONE_AXIS "your answers are those of one axis alone: the distance² is dx² + dy²"
#define MIXED_SQUARE "dx * dy is in the place of a square: the distance² is dx² + dy²"
#define NO_SQUARE "a difference was added without its square: the distance² is dx² + dy²"
    DISTANCE2(y_subtracted, squared(dx) - squared(dy), SUBTRACTED);
    DISTANCE2(x_subtracted, squared(dy) - squared(dx), SUBTRACTED);
    DIFFERENCES(swapped_axes, x_to_y, y_to_x,
                "x was compared with the centre's y, and y with its x");
    DIFFERENCES(y_to_x_alone, dx, y_to_x, MIXED_AXES);
    DIFFERENCES(x_to_y_alone, x_to_y, dy, MIXED_AXES);
    DIFFERENCES(y_for_x, y_to_x, dy, MIXED_AXES);
    DIFFERENCES(x_for_y, dx, x_to_y, MIXED_AXES);
    DIFFERENCES(x_twice, dx, dx, "your answers are those of dx² + dx²: y has no part in them");
    DIFFERENCES(y_twice, dy, dy, "your answers are those of dy² + dy²: x has no part in them");
    DIFFERENCES(x_alone, dx, 0, ONE_AXIS);
    DIFFERENCES(y_alone, 0, dy, ONE_AXIS);
    DIFFERENCES(sums, sum_x, sum_y, ADDED);
    DIFFERENCES(sum_of_x, sum_x, dy, ADDED);
    DIFFERENCES(sum_of_y, dx, sum_y, ADDED);
    DISTANCE2(product, dx * dy, "your answers are those of dx * dy: the distance² is dx² + dy²");
    DISTANCE2(product_for_x, (dx + dy) * dy, MIXED_SQUARE);
    DISTANCE2(product_for_y, dx * (dx + dy), MIXED_SQUARE);
    DISTANCE2(x_not_squared, dx + squared(dy), NO_SQUARE);
    DISTANCE2(y_not_squared, squared(dx) + dy, NO_SQUARE);
    DISTANCE2(none_squared, dx + dy, NO_SQUARE);
    COMPARES(nothing_squared, dx + dy, radius, NO_SQUARE);
    DISTANCE2(square_of_sum, squared(dx + dy),
              "your answers are those of (dx + dy)²: each has its square");
    ANSWERS(one_side, dx <= radius && dy <= radius && is_nearer,
            "your answers are those of dx and dy with their signs: a pixel may be on either side");
    ANSWERS(just_boundary, outside_by_01(in) == 0 && is_nearer,
            "your answers are those of the boundary alone: what is inside is covered, too");
#define TURNED "your answers are those of a circle that covers what is outside of it"
    ANSWERS(outside, outside_by_01(in) >= 0 && is_nearer, TURNED);
    ANSWERS(just_outside, outside_by_01(in) > 0 && is_nearer, TURNED);
    ANSWERS(either, covers_it || is_nearer,
            "your answers are those of || between the two tests: both have to hold");
    ANSWERS(by_depth, is_nearer,
            "the distance was not asked for: the circle has to cover the pixel, too");
    ANSWERS(contrary, !(covers_it && is_nearer), "1 and 0 are swapped");
    // What does not fit into an int becomes any number.
    EACH(cut_square,
         distance2 >= 0x1p31 ||
             IS_FOUND(is_within(in, trunc(distance2), squared(in.circle.radius))),
         "your answers are those of a distance² that was cut to a whole number");

    ANSWERS(by_amount, covers_with_depths(in, fabsf(in.circle.depth), fabsf(in.minDepth)),
            "your answers are those of depths without their sign: -2 is nearer than 1");
    ANSWERS(below_1, in.circle.depth < 1 && overlaps(in),
            "your answers are those of a largest depth of 1: there is none");
    ANSWERS(from_0_to_1, in.circle.depth >= 0 && in.circle.depth <= 1 && overlaps(in),
            "depths outside of 0 to 1 were refused: a depth may be any number");
    ANSWERS(before_eye, in.circle.depth >= 0 && overlaps(in),
            "circles of negative depth were refused: a depth may be any number");
    ANSWERS(behind_eye, in.circle.depth > 0 && overlaps(in),
            "circles of depth 0 or less were refused: a depth may be any number");
    ANSWERS(depth_to_radius, covers_it && in.circle.depth < in.circle.radius,
            "the circle's depth was compared with its radius, not with minDepth");
    ANSWERS(radius_to_depth, covers_it && in.circle.radius < in.minDepth,
            "the circle's radius was compared with minDepth, not its depth");
#define FARTHER "the farther circle took the pixel: the smaller depth is the nearer"
    ANSWERS(not_nearer_alone, covers_it && !is_nearer, FARTHER);
    // What does not fit into an int becomes any number.
    EACH(whole_depths,
         in.minDepth >= 0x1p31f || fabsf(in.circle.depth) >= 0x1p31f ||
             fabsf(in.minDepth) >= 0x1p31f ||
             IS_FOUND(covers_with_depths(in, truncf(in.circle.depth), truncf(in.minDepth))),
         "depths were made whole numbers: a depth may be any number");
    ANSWERS(farther, covers_with_depths(in, in.minDepth, in.circle.depth), FARTHER);

    // Wrong only where depths, or distance and radius, are equal or a little apart.
    ONLY(not_1, overlaps(in) && found,
         "the answers are 1 and 0, and no other number for true (vectors say -1)");
    ONLY(equal_depth, in.circle.depth == in.minDepth && found,
         "nearer is strict: a circle at equal depth does not take the pixel",
         MISTAKE_LATER_OF_EQUALS);
    ONLY(little_farther,
         in.circle.depth >= in.minDepth && (double)in.circle.depth - in.minDepth < SMALL && found,
         "a circle farther by however little is not nearer: no epsilon");
    ONLY(not_nearer, in.circle.depth >= in.minDepth && found,
         "the circle is not nearer than what the pixel has seen");
    ONLY(little_nearer, (double)in.minDepth - in.circle.depth < SMALL && !found,
         "a circle nearer by however little takes the pixel: no epsilon");
    ONLY(no_radius, in.circle.radius == 0 && !found,
         "a circle of radius 0 covers its centre: the boundary belongs to it");
    ONLY(boundary, outside_by_01(in) == 0 && !found,
         "strict where it should not be: the boundary belongs to the circle",
         MISTAKE_STRICT_BOUNDARY);
    ONLY(rounded_root,
         outside_by_01(in) > 0 && outside_by_01(in) <= ROOTS_ERROR * squared(in.circle.radius) &&
             found,
         "a pixel outside by however little is outside: no root, which is rounded, and no epsilon");

    ONLY(little_outside, outside_by_01(in) > 0 && outside_by_01(in) < SMALL && found,
         "a pixel outside by however little is outside: no epsilon, and nothing rounded");
    ONLY(near_outside, outside_by_01(in) > 0 && outside_by_01(in) <= 1 && found,
         "a pixel outside by however little is outside: no epsilon");
    ONLY(whole_centre, overflows || IS_FOUND(overlaps(around_whole_centre(in))), WHOLE_NUMBERS);
    ONLY(whole_differences,
         overflows || IS_FOUND(is_within(in, squared(trunc(to_x(in))) + squared(trunc(to_y(in))),
                                         squared(in.circle.radius))),
         WHOLE_NUMBERS);
    return NO_MORE;
}

// ---- Answers ------------------------------------------------------------------------------------

static char *describe(const void *job, int i, const void *answers)
{
    GIVEN;
    return message_new(
        "pixel (%d, %d), circle at %s depth %.9g, minDepth %.9g: found %d, expected %d", in.x, in.y,
        words_circle(in.circle).text, in.circle.depth, in.minDepth, found, overlaps(in));
}

const Function overlaps_01 = {"overlaps", N_OVERLAPS, sizeof(i32),
                              KNOWING(is_right, describe, known), .knows_constant = 1};
