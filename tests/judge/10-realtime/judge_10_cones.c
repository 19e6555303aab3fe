// Lab 10: does a tile's cone miss a sphere? Judged; judge_10_cone_inputs.c rolls them.
#include "judge_10.h"

#include "message.h"
#include "oracle_vector.h"
#include "words.h"

#include <math.h>

// How far off rounding may be: five roundings for each part, as in oracle3d.c, and one for the
// comparison.
double cone_rounding_10(Vec3 centre, double size)
{
    return 16 * 0x1p-24 * (vector_length(vector_of(centre)) + size);
}

// A sphere as seen in the plane through axis and centre, and how far it is from the cone.
typedef struct ConeView {
    double along, aside, size;
    double cube;    // the largest coordinate of what is beside the axis
    double border;  // the centre's distance from the border's line: negative inside
    double cone;    // from the cone itself; 0 inside
    double error;   // how far a right solution may be off
} ConeView;

static ConeView view_of(const ConeJob *in)
{
    const OracleVector centre = vector_of(in->centre), axis = vector_of(in->axis);
    ConeView view = {.along = vector_dot(centre, axis), .size = fabs((double)in->radius)};
    const OracleVector beside = vector_minus(centre, vector_scaled(view.along, axis));
    view.aside = vector_length(beside);
    view.cube = fmax(fmax(fabs(beside.x), fabs(beside.y)), fabs(beside.z));
    view.border = view.aside * (double)in->cosine - view.along * (double)in->sine;
    const int is_beside = view.along * (double)in->cosine + view.aside * (double)in->sine > 0;
    view.cone = view.border <= 0 ? 0 : is_beside ? view.border : vector_length(centre);
    view.error = cone_rounding_10(in->centre, view.size);
    return view;
}

// How far a ray of the cone's border is outside of the sphere, or how deep inside.
static double gap_of(ConeView view)
{
    return view.border - view.size;
}

static int is_right_for(ConeView view, int found)
{
    const int may_keep = gap_of(view) <= view.error || view.along <= view.error;
    const int may_miss = view.cone - view.size >= -view.error && gap_of(view) >= -view.error;
    // Behind the eye an exact answer knows more than the border's line does.
    const int may_miss_behind = view.along <= 0 && view.cone - view.size >= -view.error;
    return found ? (may_miss || may_miss_behind) : may_keep;
}

// What is expected of a mistake is its gap.
#define GIVEN                                                                                      \
    const ConeJob *in = &((const Job10 *)job)->cones[i];                                           \
    const int found = ((const i32 *)answers)[i];                                                   \
    const ConeView view = view_of(in)
#define IS_FOUND(gap) (fabs(gap) <= view.error || found == ((gap) > 0))

RIGHT(is_right, is_right_for(view, found))

// ---- Mistakes -----------------------------------------------------------------------------------

// A gap by other distances beside the axis and along it.
static double gap_by(const ConeJob *in, double aside, double along)
{
    return aside * (double)in->cosine - along * (double)in->sine - fabs((double)in->radius);
}

static double from_eye(ConeView view)
{
    return hypot(view.along, view.aside);
}

// How far off it is where the distance beside the axis comes of a difference of squares: six
// roundings of squares of the centre's distance.
static double error_by_squares(ConeView view)
{
    const double error = 6 * 0x1p-24 * (view.along * view.along + view.aside * view.aside);
    return view.error + fmin(sqrt(error), error / view.aside);
}

KNOWN_LIST(known)
{
    GIVEN;

    ANSWERS(
        never, -INFINITY,
        "that is as if no sphere were ever missed: return 1 where all rays of the cone miss it");
    ANSWERS(always, INFINITY,
            "that is as if every sphere were missed: return 0 where a ray of the cone may hit it");
    ANSWERS(inverted, -gap_of(view), "1 and 0 are swapped: 1 where every ray misses");
    ANSWERS(radius_signed, view.border - (double)in->radius,
            "the radius may be negative: how large it is, is fabs(radius)");
    ANSWERS(sine_for_cosine,
            -view.size - view.along * (double)in->cosine + view.aside * (double)in->sine,
            "sine and cosine are swapped");
    ANSWERS(other_side, gap_by(in, view.aside, -view.along),
            "the cone grows wider away from the eye: that part is taken off, not added");
    ANSWERS(axis_only, view.aside - view.size,
            "that is as if the cone were its axis: rays beside it may hit what the axis misses");
    ANSWERS(without_radius, view.border,
            "that is as if the sphere were its centre: compare with the radius");
    ANSWERS(
        across_axis, view.border / (double)in->cosine - view.size,
        "the distance from the border is measured at right angles to the border, not to the axis");
    ANSWERS(by_square, view.border - view.size * view.size, "a distance is compared with a square");
    ANSWERS(diameter, view.border - 2 * view.size,
            "spheres that the cone misses by less than twice the radius are asked all the same");
    ANSWERS(eye_distance, gap_by(in, from_eye(view), view.along),
            "the centre's distance from the axis counts, not that from the eye");
    ANSWERS(squared, fabs(view.border) - view.size,
            "the distance lost its sign: a centre inside of the border counts as if it were as far "
            "outside");
    ANSWERS(behind_missed, view.along < 0 ? 1 : gap_of(view),
            "a sphere whose centre is behind the eye may reach before it");
    ANSWERS(by_tangent, in->cosine < 0 ? -gap_of(view) : gap_of(view),
            "divided by the cosine, which may be negative: that turns the comparison round");
    ANSWERS(unit_centre, view.border / from_eye(view) - view.size,
            "the centre was made a unit vector: its distance is lost");
    ANSWERS(only_behind, -view.along - view.size,
            "only spheres whose centre is behind the eye are left out");
    ANSWERS(unit_along, gap_by(in, view.aside, view.along / from_eye(view)),
            "along the axis counts a distance, not the cosine of the centre's angle");
    ANSWERS(cube, gap_by(in, view.cube, view.along),
            "the distance beside the axis is a length, not the largest coordinate");
    ANSWERS(without_cosine, view.aside - view.along * (double)in->sine - view.size,
            "the cosine is missing: how far the centre is beside the axis is multiplied by it");
    ANSWERS(cosine_size,
            fabs((double)in->cosine) * view.aside - view.along * (double)in->sine - view.size,
            "the cosine may be negative, and stays so: nothing is outside of the cone then");
    ANSWERS(behind_plane, view.along < -view.size ? 1 : gap_of(view),
            "where the cosine is -1 rays go to all sides: what is behind the eye is not missed, "
            "either");
    ANSWERS(by_distance, gap_by(in, view.aside, from_eye(view)),
            "the sine goes with the part along the axis, not with the distance from the eye");
    ANSWERS(radius_added, view.border + view.size,
            "the radius is on the wrong side: a sphere is missed where it is farther from the "
            "border than its radius");
    ANSWERS(half_radius, view.border - view.size / 2,
            "that is as if the sphere were half as large: compare with the radius");
    ANSWERS(along_size,
            gap_by(in, hypot(view.aside, view.along - fabs(view.along)), fabs(view.along)),
            "the part along the axis may be negative, and stays so: behind the eye is outside of "
            "the cone");
    ANSWERS(both_squared,
            pow(view.aside, 2) * (double)in->cosine - view.along * (double)in->sine -
                view.size * view.size,
            "squares and distances are mixed: take the length");
    ANSWERS(from_axis_end, gap_by(in, hypot(view.along - 1, view.aside), view.along),
            "what is beside the axis is centre - along * axis: the axis is a unit vector");

#define EPSILON "the radius is compared with as it is, without an epsilon: the cone is wide enough"
    static const double epsilons[] = {1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6};
    ONE_OF(added, 5, IS_FOUND(gap_of(view) - epsilons[way + 1]), EPSILON);
    ONE_OF(share, 5, IS_FOUND(gap_of(view) - epsilons[way] * view.size), EPSILON);

    ONLY(by_squares, fabs(gap_of(view)) <= error_by_squares(view),
         "the digits are lost: subtract the vectors first, and then take the length");
    return NO_MORE;
}

// ---- Answers ------------------------------------------------------------------------------------

static char *describe(const void *job, int i, const void *answers)
{
    GIVEN;
    return message_new(
        "axis %s, sine %.6g, cosine %.6g, sphere %s radius %.9g, which is %.6g along "
        "the axis and %.6g beside it, and %.9g from the cone's border: found %d, expected %d",
        words_vec3(in->axis, 6).text, in->sine, in->cosine, words_vec3(in->centre, 6).text,
        in->radius, view.along, view.aside, view.border, found, gap_of(view) > 0);
}

const Function cone_10 = {"cones", N_CONES, sizeof(i32), KNOWING(is_right, describe, known),
                          .knows_constant = 1};
