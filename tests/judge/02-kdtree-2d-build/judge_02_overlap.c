// Lab 02: circle_overlaps_box on the job's inputs. See judge_02.h.
#include "judge_02.h"

#include "message.h"
#include "oracle2d.h"
#include "overlap_reach.h"
#include "words.h"

#define GIVEN                                                                                      \
    const BoxOverlapJob in = ((const Job02 *)job)->overlaps[i];                                    \
    const Circle circle = in.circle;                                                               \
    const BBox2D box = in.box;                                                                     \
    const Reach reach = {                                                                          \
        {outside_of(circle.x, box.minX, box.maxX), outside_of(circle.y, box.minY, box.maxY)},      \
        circle.radius};                                                                            \
    const int found = ((const i32 *)answers)[i];                                                   \
    (void)circle, (void)box, (void)reach
#define IS_FOUND(expected) (found == (expected))

#include "overlap_known.h"

RIGHT(is_right, IS_FOUND(oracle2d_overlaps_box(circle, box)))

// ---- Mistakes, in double ------------------------------------------------------------------------

static double squared(double value)
{
    return value * value;
}

static double clamped(double value, double low, double high)
{
    return fmin(fmax(value, low), high);
}

static int covers(Circle circle, double x, double y)
{
    return squared(circle.x - x) + squared(circle.y - y) <= squared(circle.radius);
}

static int holds(BBox2D box, double x, double y)
{
    return x >= box.minX && x <= box.maxX && y >= box.minY && y <= box.maxY;
}

// So do distances squared that are negative within the cell's width and height.
static int covers_corner(Circle circle, BBox2D box)
{
    return covers(circle, box.minX, box.minY) || covers(circle, box.minX, box.maxY) ||
           covers(circle, box.maxX, box.minY) || covers(circle, box.maxX, box.maxY);
}

static int holds_tip(Circle circle, BBox2D box)
{
    return holds(box, (double)circle.x - circle.radius, circle.y) ||
           holds(box, (double)circle.x + circle.radius, circle.y) ||
           holds(box, circle.x, (double)circle.y - circle.radius) ||
           holds(box, circle.x, (double)circle.y + circle.radius);
}

#define BY_CENTRE "your answers are those of the centre alone: a circle has a radius"
#define OTHER_AXIS "your answers are those of one axis clamped by a border of the other"

// The border, and not what is within it.
static double to_border(double value, double low, double high)
{
    return fmin(fabs(value - low), fabs(value - high));
}

// Clamped by borders of either axis: each bit of `way` takes another border, or the maximum first.
static double clamped_some_way(double value, double low, double high, int is_max_first)
{
    return is_max_first ? fmax(fmin(value, high), low) : clamped(value, low, high);
}

static int covers_some_way(Circle circle, BBox2D box, int way)
{
    const double x = clamped_some_way(circle.x, way & 1 ? box.minY : box.minX,
                                      way & 2 ? box.maxY : box.maxX, way & 16);
    const double y = clamped_some_way(circle.y, way & 4 ? box.minX : box.minY,
                                      way & 8 ? box.maxX : box.maxY, way & 16);
    return covers(circle, x, y);
}

// One axis wrong: the cell's nearest coordinate, or its distance from the centre's.
#define ON_X(name, x, ...) ANSWERS(name, covers(circle, x, nearest_y), __VA_ARGS__)
#define ON_Y(name, y, ...) ANSWERS(name, covers(circle, nearest_x, y), __VA_ARGS__)
#define DISTANCE2(name, expression, ...)                                                           \
    ANSWERS(name, (expression) <= squared(circle.radius), __VA_ARGS__)
#define DIFFERENCES(name, x, y, ...) DISTANCE2(name, squared(x) + squared(y), __VA_ARGS__)

KNOWN_LIST(known)
{
    GIVEN;
    const int holds_centre = holds(box, circle.x, circle.y);
    const int has_corner = covers_corner(circle, box);
    const int has_tip = holds_tip(circle, box);
    const int overlaps = oracle2d_overlaps_box(circle, box);
    const double middle_x = ((double)box.minX + box.maxX) / 2;
    const double middle_y = ((double)box.minY + box.maxY) / 2;
    const double nearest_x = clamped(circle.x, box.minX, box.maxX);
    const double nearest_y = clamped(circle.y, box.minY, box.maxY);
    const double dx = circle.x - nearest_x;
    const double dy = circle.y - nearest_y;

    EACH(just_1_and_0, (found != 0) == overlaps, JUST_1_AND_0);
    ANSWERS(by_centre, holds_centre, BY_CENTRE);
    ANSWERS(by_open_centre, holds_centre && circle.x < box.maxX && circle.y < box.maxY, BY_CENTRE);
    ANSWERS(
        corners, has_corner,
        "your answers are those of the cell's corners alone: within its width the distance is 0");
    ANSWERS(with_centre, has_corner || holds_centre,
            "your answers are those of corners and centre: a circle may reach over one side only");
    ANSWERS(
        with_tips, has_corner || holds_centre || has_tip,
        "your answers are those of corners, centre and tips: any other point may be the nearest");
#define BY_MIDDLE "your answers are those of the cell's middle, and another point may be nearer"
    ANSWERS(middle, covers(circle, middle_x, middle_y), BY_MIDDLE);

    ANSWERS(border,
            holds_centre ? fmin(to_border(circle.x, box.minX, box.maxX),
                                to_border(circle.y, box.minY, box.maxY)) <= circle.radius
                         : overlaps,
            "a circle within the cell, far from its border, overlaps it all the same");
    ANSWERS(min_for_max,
            covers(circle, fmin(box.minX, fmax(circle.x, box.maxX)),
                   fmin(box.minY, fmax(circle.y, box.maxY))),
            "your answers are those of fmin and fmax in each other's places");
#define ONE_BORDER                                                                                 \
    "your answers are those of a centre that is clamped by one border of an axis: a cell has two"
    ANSWERS(max_for_min, covers(circle, box.maxX, box.maxY),
            "your answers are those of fmin and fmax in each other's places");
#define ONE_SIDE "your answers are those of one border of each axis alone: a cell has two"
    ANSWERS(lower_alone,
            circle.x + circle.radius >= box.minX && circle.y + circle.radius >= box.minY, ONE_SIDE);
    ANSWERS(upper_alone,
            circle.x - circle.radius <= box.maxX && circle.y - circle.radius <= box.maxY, ONE_SIDE);
    ANSWERS(contrary, !overlaps, "1 and 0 are swapped: 1 means that they overlap");
    ANSWERS(half_radius, 4 * reach_squared(reach) <= squared(circle.radius),
            "your answers are those of half the radius");
    ANSWERS(twice_radius, reach_squared(reach) <= 4 * squared(circle.radius),
            "your answers are those of twice the radius");
    ANSWERS(subtracted,
            squared(reach.outside[0]) - squared(reach.outside[1]) <= squared(circle.radius),
            "the squares of both distances are added, not subtracted");
    ANSWERS(
        one_is_enough, reach.outside[0] <= circle.radius || reach.outside[1] <= circle.radius,
        "your answers are those of || between the axes: the distance takes both of them together");
    ANSWERS(whole_border,
            covers(circle, trunc(clamped(circle.x, box.minX, box.maxX)),
                   trunc(clamped(circle.y, box.minY, box.maxY))),
            "the nearest point was made a whole number: a border may lie between two pixels");
    ANSWERS(by_min, covers(circle, fmax(circle.x, box.minX), fmax(circle.y, box.minY)), ONE_BORDER);
    ANSWERS(by_max, covers(circle, fmin(circle.x, box.maxX), fmin(circle.y, box.maxY)), ONE_BORDER);

    ANY(other_axis, 32, IS_FOUND(covers_some_way(circle, box, way)), OTHER_AXIS);

#define FIXED                                                                                      \
    "on one axis your nearest coordinate is always the same border: it is the centre's own where " \
    "that is between the two"
    ON_X(x_at_min, box.minX, FIXED);
    ON_X(x_at_max, box.maxX, FIXED);
    ON_Y(y_at_min, box.minY, FIXED);
    ON_Y(y_at_max, box.maxY, FIXED);
    ON_X(x_by_min, fmax(circle.x, box.minX), ONE_BORDER);
    ON_X(x_by_max, fmin(circle.x, box.maxX), ONE_BORDER);
    ON_Y(y_by_min, fmax(circle.y, box.minY), ONE_BORDER);
    ON_Y(y_by_max, fmin(circle.y, box.maxY), ONE_BORDER);
    ON_X(x_of_middle, middle_x, BY_MIDDLE);
    ON_Y(y_of_middle, middle_y, BY_MIDDLE);
#define LEVEL "your answers are those of a centre that has to be between the borders of one axis"
    ANSWERS(level_in_x, reach.outside[0] == 0 && overlaps, LEVEL);
    ANSWERS(level_in_y, reach.outside[1] == 0 && overlaps, LEVEL);
#define INWARDS "your nearest coordinate is pushed away from the cell: fmin and fmax are mixed up"
    ON_X(x_below, fmin(circle.x, box.minX), INWARDS);
    ON_X(x_above, fmax(circle.x, box.maxX), INWARDS);
    ON_Y(y_below, fmin(circle.y, box.minY), INWARDS);
    ON_Y(y_above, fmax(circle.y, box.maxY), INWARDS);
#define MIXED_AXES "x and y of the centre are mixed up: each axis takes its own coordinate"
    ON_X(x_of_y, clamped(circle.y, box.minX, box.maxX), MIXED_AXES);
    ON_Y(y_of_x, clamped(circle.x, box.minY, box.maxY), MIXED_AXES);
    DIFFERENCES(y_to_x, circle.y - nearest_x, dy, MIXED_AXES);
    DIFFERENCES(x_to_y, dx, circle.x - nearest_y, MIXED_AXES);
#define MIXED_NEAREST                                                                              \
    "x and y of the nearest point are mixed up: each axis takes its own coordinate"
    DIFFERENCES(to_nearest_y, circle.x - nearest_y, dy, MIXED_NEAREST);
    DIFFERENCES(to_nearest_x, dx, circle.y - nearest_x, MIXED_NEAREST);
#define ADDED "your answers are those of centre plus nearest point: dx and dy are differences"
    DIFFERENCES(sum_of_x, circle.x + nearest_x, dy, ADDED);
    DIFFERENCES(sum_of_y, dx, circle.y + nearest_y, ADDED);
    DIFFERENCES(sums, circle.x + nearest_x, circle.y + nearest_y, ADDED);
#define TWICE "your answers are those of one axis, twice: the distance² is dx² + dy²"
    DIFFERENCES(x_twice, dx, dx, TWICE);
    DIFFERENCES(y_twice, dy, dy, TWICE);
#define MIXED_SQUARE "dx * dy is in the place of a square: the distance² is dx² + dy²"
    DISTANCE2(product, dx * dy, MIXED_SQUARE);
    DISTANCE2(product_for_x, (dx + dy) * dy, MIXED_SQUARE);
    DISTANCE2(product_for_y, dx * (dx + dy), MIXED_SQUARE);
    DISTANCE2(square_of_sum, squared(dx + dy),
              "your answers are those of (dx + dy)²: each has its square");
#define NO_SQUARE "a difference was added without its square: the distance² is dx² + dy²"
    DISTANCE2(x_not_squared, dx + squared(dy), NO_SQUARE);
    DISTANCE2(y_not_squared, squared(dx) + dy, NO_SQUARE);
    ANSWERS(distance_rooted, sqrt(reach_squared(reach)) <= squared(circle.radius),
            "your answers are those of distance <= radius²: compare the squares of both");
    ANSWERS(turned, reach_squared(reach) >= squared(circle.radius),
            "your answers are those of a comparison the wrong way round");
#define WHOLE "your answers are those of whole numbers: a centre may lie between two pixels"
    DIFFERENCES(whole_distances, trunc(dx), trunc(dy), WHOLE);
    DIFFERENCES(whole_centre, trunc(circle.x) - clamped(trunc(circle.x), box.minX, box.maxX),
                trunc(circle.y) - clamped(trunc(circle.y), box.minY, box.maxY), WHOLE);
    ANSWERS(whole_radius, reach_squared(reach) <= squared(trunc(circle.radius)), WHOLE);

    ANSWERS(circle_around,
            hypot(circle.x - middle_x, circle.y - middle_y) <=
                circle.radius + hypot(box.maxX - middle_x, box.maxY - middle_y),
            "your answers are those of a circle around the cell");
    EACH(square, is_of_box(reach, found),
         "the circle's bounding square overlaps, the circle does not");

    ONLY(level, !found && (reach.outside[0] == 0 || reach.outside[1] == 0),
         "where the centre is between two opposite borders, the distance on that axis is 0");
    return NO_MORE;
}

// ---- Answers ------------------------------------------------------------------------------------

static char *describe(const void *job, int i, const void *answers)
{
    GIVEN;
    return message_new("circle at %s, box %s: found %d, expected %d", words_circle(circle).text,
                       words_box2d(box).text, found, oracle2d_overlaps_box(circle, box));
}

const Function overlap_02 = {"overlaps", N_OVERLAPS, sizeof(i32),
                             KNOWING(is_right, describe, overlap_known, known),
                             .knows_constant = 1};
