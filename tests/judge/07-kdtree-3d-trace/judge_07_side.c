// Judging the answers of lab 07's near_side: nothing is rounded.
#include "judge_07.h"
#include "message.h"

#include <math.h>

enum {
    SIDE_SWAPPED = 1,
    SIDE_BY_DIRECTION,
    SIDE_INTO,
    SIDE_ON_PLANE_LOWER,
    SIDE_ON_PLANE_UPPER,
    SIDE_ON_PLANE_SWAPPED,
    SIDE_IS_ID,
    SIDE_AWAY,
    SIDE_WHOLE,
    // The answer is right, or other near a border: of an epsilon, whose size is not known.
    SIDE_ALONG,
    SIDE_HAIR_ON_PLANE,
    SIDE_SMALL_IS_ALONG,
};
static const Cause side_mistakes[] = {
    [SIDE_SWAPPED] = {.says = "that is the far side: near and far are swapped"},
    [SIDE_BY_DIRECTION] = {.says = "that is as if the direction decided, wherever the eye is"},
    [SIDE_INTO] = {.says = "that is as if the ray's way decided, wherever the eye is"},
    [SIDE_ON_PLANE_LOWER] =
        {.says = "an eye on the plane was sent to the lower child, wherever the ray goes"},
    [SIDE_ON_PLANE_UPPER] =
        {.says = "an eye on the plane was sent to the upper child, wherever the ray goes"},
    [SIDE_ON_PLANE_SWAPPED] = {.says = "with the eye on the plane the near child is the one the "
                                       "ray goes into, not the one it comes from"},
    [SIDE_IS_ID] = {.says = "that is the id of a child; 0 and 1 are the sides"},
    [SIDE_AWAY] = {.says = "that is as if it counted whether the ray goes away from the plane: the "
                           "eye's side is its side, whichever way it looks"},
    [SIDE_WHOLE] = {.says = "eye and plane were compared as whole numbers"},
    [SIDE_ALONG] = {.says = "only rays along the plane are wrong: of them, too, the near child is "
                            "the one on the eye's side"},
    [SIDE_HAIR_ON_PLANE] =
        {.says = "an eye a hair beside the plane is not on it: compare without an epsilon"},
    [SIDE_SMALL_IS_ALONG] =
        {.says = "only the sign of the direction counts, however small or large it is"},
};

// Is the ray along the plane? Then the eye is on either side when it is on the plane.
static int is_along(const SideJob *job)
{
    return job->inverse == 0 || isinf(job->inverse);
}

// May the answer be any where this is the mistake? It may treat -0 or an infinite number in its own
// way.
static int is_free_side(const SideJob *job, int mistake)
{
    const float distance = fabsf(job->origin - job->node.split_pos);
    const int is_by_direction =
        mistake == SIDE_BY_DIRECTION || mistake == SIDE_INTO || mistake == SIDE_AWAY;
    const int is_small = fabsf(job->inverse) < (float)HAIR || fabsf(job->inverse) > 1000;
    return (is_along(job) && (distance == 0 || is_by_direction || mistake == SIDE_ALONG)) ||
           (mistake == SIDE_HAIR_ON_PLANE && distance > 0 && distance < (float)HAIR) ||
           (mistake == SIDE_SMALL_IS_ALONG && distance == 0 && is_small);
}

static u32 expected_side(const SideJob *job, int mistake)
{
    const int is_whole = mistake == SIDE_WHOLE;
    const f32 plane = is_whole ? truncf(job->node.split_pos) : job->node.split_pos;
    const f32 origin = is_whole ? truncf(job->origin) : job->origin;
    u32 side = origin < plane ? 0 : origin > plane ? 1 : job->inverse > 0;
    if (origin == plane) {
        side = mistake == SIDE_ON_PLANE_LOWER     ? 0
               : mistake == SIDE_ON_PLANE_UPPER   ? 1
               : mistake == SIDE_ON_PLANE_SWAPPED ? !side
                                                  : side;
    }
    side = mistake == SIDE_BY_DIRECTION              ? job->inverse < 0
           : mistake == SIDE_INTO                    ? job->inverse > 0
           : mistake == SIDE_AWAY && origin != plane ? (origin > plane) == (job->inverse > 0)
                                                     : side;
    side = mistake == SIDE_SWAPPED ? !side : side;
    return mistake == SIDE_IS_ID ? job->node.first + side : side;
}

static int side_agrees(const void *pointer, int i, const void *answers, int mistake)
{
    const SideJob *job = &((const Job07 *)pointer)->inputs.sides[i];
    const u32 found = ((const u32 *)answers)[i];
    return found == expected_side(job, mistake) ||
           (is_free_side(job, mistake) && (mistake != 0 || found <= 1));
}

static char *describe_side(const void *pointer, int i, const void *answers)
{
    const SideJob *job = &((const Job07 *)pointer)->inputs.sides[i];
    return message_new("plane at %.9g, eye at %.9g, 1 / direction %g: found %u, expected %u",
                       job->node.split_pos, job->origin, job->inverse, ((const u32 *)answers)[i],
                       expected_side(job, 0));
}

const Function side_07 = {"sides", 2 * N_SIDE_INPUTS, sizeof(u32),
                          COMPARED(side_agrees, describe_side, side_mistakes)};
