// Judging the answers of lab 07's near_side: nothing is rounded.
#include "judge_07.h"
#include "message.h"

#include <math.h>

// On the plane and along it the eye is on either side. A mistake may treat -0 or an infinite number
// in its own way there.
enum { LOWER, UPPER, EITHER };

#define GIVEN                                                                                      \
    const SideJob *in = &((const Job07 *)job)->inputs.sides[i];                                    \
    const u32 found = ((const u32 *)answers)[i]
#define IS_FOUND(expected) (found == (expected) || (expected) == EITHER)

// ---- Right --------------------------------------------------------------------------------------

static int is_along(const SideJob *in)
{
    return in->inverse == 0 || isinf(in->inverse);
}

static u32 side_of(const SideJob *in, float eye, float plane)
{
    return eye < plane ? LOWER : eye > plane ? UPPER : is_along(in) ? EITHER : in->inverse > 0;
}

static u32 near_side(const SideJob *in)
{
    return side_of(in, in->origin, in->node.split_pos);
}

RIGHT(is_right, found <= UPPER && IS_FOUND(near_side(in)))

// ---- Mistakes -----------------------------------------------------------------------------------

static u32 other_side(u32 side)
{
    return side == EITHER ? EITHER : !side;
}

// Right, but where the eye is on the plane.
static u32 on_plane(const SideJob *in, u32 side)
{
    return in->origin == in->node.split_pos && !is_along(in) ? side : near_side(in);
}

static u32 by_direction(const SideJob *in, int is_upper)
{
    return is_along(in) ? EITHER : is_upper;
}

static u32 away_from_plane(const SideJob *in)
{
    return in->origin == in->node.split_pos
               ? near_side(in)
               : by_direction(in, (in->origin > in->node.split_pos) == (in->inverse > 0));
}

// A side for an eye below, above, and on the plane: LOWER, UPPER, or by the direction, 2, or
// against it, 3.
static u32 side_by(const SideJob *in, int below, int above, int on)
{
    const int by = in->origin < in->node.split_pos   ? below
                   : in->origin > in->node.split_pos ? above
                                                     : on;
    return by <= UPPER ? (u32)by : is_along(in) ? EITHER : (in->inverse > 0) == (by == 2);
}

// An epsilon, whose size is not known.
static float from_plane(const SideJob *in)
{
    return fabsf(in->origin - in->node.split_pos);
}

KNOWN_LIST(known)
{
    GIVEN;

    ANSWERS(far_side, other_side(near_side(in)), "that is the far side: near and far are swapped");

    ANY(other_sides, 64, IS_FOUND(side_by(in, way % 4, way / 4 % 4, way / 16)),
        "an eye below the plane is on side 0, an eye above it on side 1, whatever the direction: "
        "for one of them, or both, it is another");
    ANSWERS(coming_from, by_direction(in, in->inverse < 0),
            "that is as if the direction decided, wherever the eye is");
    ANSWERS(going_to, by_direction(in, in->inverse > 0),
            "that is as if the ray's way decided, wherever the eye is");
    ANSWERS(plane_is_lower, on_plane(in, LOWER),
            "an eye on the plane was sent to the lower child, wherever the ray goes");
    ANSWERS(plane_is_upper, on_plane(in, UPPER),
            "an eye on the plane was sent to the upper child, wherever the ray goes");
    ANSWERS(plane_is_other, on_plane(in, other_side(near_side(in))),
            "with the eye on the plane the near child is the one the ray goes into, not the one it "
            "comes from");
    ANSWERS(child_id, near_side(in) == EITHER ? EITHER : in->node.first + near_side(in),
            "that is the id of a child; 0 and 1 are the sides");
    ANSWERS(away, away_from_plane(in),
            "that is as if it counted whether the ray goes away from the plane: the eye's side is "
            "its side, whichever way it looks");
    ANSWERS(whole, side_of(in, truncf(in->origin), truncf(in->node.split_pos)),
            "eye and plane were compared as whole numbers");

    ONLY(along, is_along(in),
         "only rays along the plane are wrong: of them, too, the near child is the one on the "
         "eye's side");
    ONLY(hair, from_plane(in) > 0 && from_plane(in) < (float)HAIR,
         "an eye a hair beside the plane is not on it: compare without an epsilon");
    ONLY(small,
         from_plane(in) == 0 && (fabsf(in->inverse) < (float)HAIR || fabsf(in->inverse) > 1000),
         "only the sign of the direction counts, however small or large it is");

    ONLY(on_plane_only, from_plane(in) == 0,
         "only eyes on the plane are wrong: there the sign of inverse decides, and nothing else");
    return NO_MORE;
}

// ---- Answers ------------------------------------------------------------------------------------

static const char *side_words(u32 side)
{
    return side == LOWER ? ", the lower child" : side == UPPER ? ", the upper child" : "";
}

static char *describe(const void *job, int i, const void *answers)
{
    GIVEN;
    const u32 expected = near_side(in) == EITHER ? LOWER : near_side(in);
    return message_new("plane at %.9g, eye at %.9g, 1 / direction %g: found %u%s, expected %u%s",
                       in->node.split_pos, in->origin, in->inverse, found, side_words(found),
                       expected, side_words(expected));
}

const Function side_07 = {"sides", 2 * N_SIDE_INPUTS, sizeof(u32),
                          KNOWING(is_right, describe, known)};
