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

#define OVERLAPS oracle2d_overlaps_box(circle, box)

RIGHT(is_right, IS_FOUND(OVERLAPS))

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

#define HOLDS_CENTRE holds(box, circle.x, circle.y)
// So do distances squared that are negative within the cell's width and height.
#define COVERS_CORNER                                                                              \
    (covers(circle, box.minX, box.minY) || covers(circle, box.minX, box.maxY) ||                   \
     covers(circle, box.maxX, box.minY) || covers(circle, box.maxX, box.maxY))
#define HOLDS_TIP                                                                                  \
    (holds(box, (double)circle.x - circle.radius, circle.y) ||                                     \
     holds(box, (double)circle.x + circle.radius, circle.y) ||                                     \
     holds(box, circle.x, (double)circle.y - circle.radius) ||                                     \
     holds(box, circle.x, (double)circle.y + circle.radius))
#define MIDDLE_X (((double)box.minX + box.maxX) / 2)
#define MIDDLE_Y (((double)box.minY + box.maxY) / 2)
#define BY_CENTRE "your answers are those of the centre alone: a circle has a radius"
#define OTHER_AXIS "your answers are those of one axis clamped by a border of the other"

EACH(just_1_and_0, (found != 0) == OVERLAPS, JUST_1_AND_0)
ANSWERS(by_centre, HOLDS_CENTRE, BY_CENTRE)
ANSWERS(by_open_centre, HOLDS_CENTRE &&circle.x < box.maxX && circle.y < box.maxY, BY_CENTRE)
ANSWERS(corners, COVERS_CORNER,
        "your answers are those of the cell's corners alone: within its width the distance is 0")
ANSWERS(with_centre, COVERS_CORNER || HOLDS_CENTRE,
        "your answers are those of corners and centre: a circle may reach over one side only")
ANSWERS(with_tips, COVERS_CORNER || HOLDS_CENTRE || HOLDS_TIP,
        "your answers are those of corners, centre and tips: any other point may be the nearest")
ANSWERS(middle, covers(circle, MIDDLE_X, MIDDLE_Y),
        "your answers are those of the cell's middle, and another point may be nearer")

// The border, and not what is within it.
static double to_border(double value, double low, double high)
{
    return fmin(fabs(value - low), fabs(value - high));
}

ANSWERS(border,
        HOLDS_CENTRE ? fmin(to_border(circle.x, box.minX, box.maxX),
                            to_border(circle.y, box.minY, box.maxY)) <= circle.radius
                     : OVERLAPS,
        "a circle within the cell, far from its border, overlaps it all the same")
ANSWERS(min_for_max,
        covers(circle, fmin(box.minX, fmax(circle.x, box.maxX)),
               fmin(box.minY, fmax(circle.y, box.maxY))),
        "your answers are those of fmin and fmax in each other's places")
#define ONE_BORDER                                                                                 \
    "your answers are those of a centre that is clamped by one border of each axis: a cell has "   \
    "two"
ANSWERS(max_for_min, covers(circle, box.maxX, box.maxY),
        "your answers are those of fmin and fmax in each other's places")
#define ONE_SIDE "your answers are those of one border of each axis alone: a cell has two"
ANSWERS(lower_alone, circle.x + RADIUS >= box.minX && circle.y + RADIUS >= box.minY, ONE_SIDE)
ANSWERS(upper_alone, circle.x - RADIUS <= box.maxX && circle.y - RADIUS <= box.maxY, ONE_SIDE)
ANSWERS(contrary, !OVERLAPS, "1 and 0 are swapped: 1 means that they overlap")
ANSWERS(half_radius, 4 * D2 <= RADIUS * RADIUS, "your answers are those of half the radius")
ANSWERS(twice_radius, D2 <= 4 * RADIUS * RADIUS, "your answers are those of twice the radius")
ANSWERS(subtracted, squared(reach.outside[0]) - squared(reach.outside[1]) <= RADIUS * RADIUS,
        "the squares of both distances are added, not subtracted")
ANSWERS(one_is_enough, reach.outside[0] <= RADIUS || reach.outside[1] <= RADIUS,
        "your answers are those of || between the axes: the distance takes both of them together")
ANSWERS(whole_border,
        covers(circle, trunc(clamped(circle.x, box.minX, box.maxX)),
               trunc(clamped(circle.y, box.minY, box.maxY))),
        "the nearest point was made a whole number: a border may lie between two pixels")
ANSWERS(by_min, covers(circle, fmax(circle.x, box.minX), fmax(circle.y, box.minY)), ONE_BORDER)
ANSWERS(by_max, covers(circle, fmin(circle.x, box.maxX), fmin(circle.y, box.maxY)), ONE_BORDER)
ANSWERS(y_by_max_x,
        covers(circle, clamped(circle.x, box.minX, box.maxX),
               clamped(circle.y, box.minY, box.maxX)),
        OTHER_AXIS)
ANSWERS(y_by_x,
        covers(circle, clamped(circle.x, box.minX, box.maxX),
               clamped(circle.y, box.minX, box.maxX)),
        OTHER_AXIS)
ANSWERS(x_by_y,
        covers(circle, clamped(circle.x, box.minY, box.maxY),
               clamped(circle.y, box.minY, box.maxY)),
        OTHER_AXIS)
ANSWERS(circle_around,
        hypot(circle.x - MIDDLE_X, circle.y - MIDDLE_Y) <=
            circle.radius + hypot(box.maxX - MIDDLE_X, box.maxY - MIDDLE_Y),
        "your answers are those of a circle around the cell")
EACH(square, IS_OF_BOX, "the circle's bounding square overlaps, the circle does not")

ONLY(level, !found && (reach.outside[0] == 0 || reach.outside[1] == 0),
     "where the centre is between two opposite borders, the distance on that axis is 0")

static const Known *const known[] = {
    &just_1_and_0, &by_centre,    &by_open_centre, &corners,     &with_centre,   &with_tips,
    &middle,       &border,       &min_for_max,    &max_for_min, &lower_alone,   &upper_alone,
    &contrary,     &half_radius,  &twice_radius,   &subtracted,  &one_is_enough, &whole_border,
    &by_min,       &by_max,       &y_by_max_x,     &y_by_x,      &x_by_y,        &circle_around,
    &square,       OVERLAP_KNOWN, &level,
};

// ---- Answers ------------------------------------------------------------------------------------

static char *describe(const void *job, int i, const void *answers)
{
    GIVEN;
    return message_new("circle at %s, box %s: found %d, expected %d", words_circle(circle).text,
                       words_box2d(box).text, found, OVERLAPS);
}

const Function overlap_02 = {"overlaps", N_OVERLAPS, sizeof(i32),
                             KNOWING(is_right, describe, known), .knows_constant = 1};
