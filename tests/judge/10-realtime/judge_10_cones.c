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

enum {
    CONE_NEVER = 1,
    CONE_ALWAYS,
    CONE_INVERTED,
    CONE_RADIUS_SIGNED,
    CONE_SINE_FOR_COSINE,
    CONE_OTHER_SIDE,
    CONE_AXIS_ONLY,
    CONE_WITHOUT_RADIUS,
    CONE_ACROSS_AXIS,
    CONE_RADIUS_SQUARED,
    CONE_DIAMETER,
    CONE_FROM_EYE,
    CONE_ONLY_BEHIND,
    CONE_SQUARED,
    CONE_BEHIND_MISSED,
    CONE_BY_TANGENT,
    CONE_UNIT_CENTRE,
    CONE_UNIT_ALONG,
    CONE_CUBE,
    CONE_WITHOUT_COSINE,
    CONE_COSINE_SIZE,
    CONE_BEHIND_PLANE,
    CONE_BY_DISTANCE,
    CONE_RADIUS_ADDED,
    CONE_HALF_RADIUS,
    CONE_ALONG_SIZE,
    CONE_BOTH_SQUARED,
    CONE_FROM_AXIS_END,
    CONE_BY_SQUARES,  // the last one: those with a number follow
};

// A known mistake, and what is said about it; number 0 is none.
typedef struct ConeMistake {
    Cause cause;
    double added, share;  // to the radius, and as a share of it
} ConeMistake;

#define EPSILON                                                                                    \
    {.says = "the radius is compared with as it is, without an epsilon: the cone is wide enough"}
#define SAYS(text) {{.says = (text)}, 0, 0}

static const ConeMistake cone_mistakes[] = {
    [CONE_NEVER] = SAYS("that is as if no sphere were ever missed: return 1 where all rays of the "
                        "cone miss it"),
    [CONE_ALWAYS] = SAYS("that is as if every sphere were missed: return 0 where a ray of the cone "
                         "may hit it"),
    [CONE_INVERTED] = SAYS("1 and 0 are swapped: 1 where every ray misses"),
    [CONE_RADIUS_SIGNED] = SAYS("the radius may be negative: how large it is, is fabs(radius)"),
    [CONE_SINE_FOR_COSINE] = SAYS("sine and cosine are swapped"),
    [CONE_OTHER_SIDE] = SAYS("the cone grows wider away from the eye: that part is taken off, not "
                             "added"),
    [CONE_AXIS_ONLY] = SAYS("that is as if the cone were its axis: rays beside it may hit what the "
                            "axis misses"),
    [CONE_WITHOUT_RADIUS] =
        SAYS("that is as if the sphere were its centre: compare with the radius"),
    [CONE_ACROSS_AXIS] = SAYS("the distance from the border is measured at right angles to the "
                              "border, not to the axis"),
    [CONE_RADIUS_SQUARED] = SAYS("a distance is compared with a square"),
    [CONE_DIAMETER] = SAYS("spheres that the cone misses by less than twice the radius are asked "
                           "all the same"),
    [CONE_FROM_EYE] = SAYS("the centre's distance from the axis counts, not that from the eye"),
    [CONE_SQUARED] = SAYS("the distance lost its sign: a centre inside of the border counts as if "
                          "it were as far outside"),
    [CONE_BEHIND_MISSED] = SAYS("a sphere whose centre is behind the eye may reach before it"),
    [CONE_BY_TANGENT] = SAYS("divided by the cosine, which may be negative: that turns the "
                             "comparison round"),
    [CONE_UNIT_CENTRE] = SAYS("the centre was made a unit vector: its distance is lost"),
    [CONE_ONLY_BEHIND] = SAYS("only spheres whose centre is behind the eye are left out"),
    [CONE_UNIT_ALONG] =
        SAYS("along the axis counts a distance, not the cosine of the centre's angle"),
    [CONE_CUBE] = SAYS("the distance beside the axis is a length, not the largest coordinate"),
    [CONE_WITHOUT_COSINE] =
        SAYS("the cosine is missing: how far the centre is beside the axis is multiplied by it"),
    [CONE_COSINE_SIZE] = SAYS("the cosine may be negative, and stays so: nothing is outside of the "
                              "cone then"),
    [CONE_BEHIND_PLANE] =
        SAYS("where the cosine is -1 rays go to all sides: what is behind the eye "
             "is not missed, either"),
    [CONE_BY_DISTANCE] = SAYS("the sine goes with the part along the axis, not with the distance "
                              "from the eye"),
    [CONE_RADIUS_ADDED] = SAYS("the radius is on the wrong side: a sphere is missed where it is "
                               "farther from the border than its radius"),
    [CONE_HALF_RADIUS] = SAYS("that is as if the sphere were half as large: compare with the "
                              "radius"),
    [CONE_ALONG_SIZE] = SAYS("the part along the axis may be negative, and stays so: behind the "
                             "eye is outside of the cone"),
    [CONE_BOTH_SQUARED] = SAYS("squares and distances are mixed: take the length"),
    [CONE_FROM_AXIS_END] = SAYS("what is beside the axis is centre - along * axis: the axis is a "
                                "unit vector"),
    [CONE_BY_SQUARES] = SAYS("the digits are lost: subtract the vectors first, and then take the "
                             "length"),
    {EPSILON, .added = 1e-2},
    {EPSILON, .added = 1e-3},
    {EPSILON, .added = 1e-4},
    {EPSILON, .added = 1e-5},
    {EPSILON, .added = 1e-6},
    {EPSILON, .share = 1e-1},
    {EPSILON, .share = 1e-2},
    {EPSILON, .share = 1e-3},
    {EPSILON, .share = 1e-4},
    {EPSILON, .share = 1e-5},
};

// A sphere as seen in the plane through axis and centre, and how far it is from the cone.
typedef struct ConeView {
    double along, aside, size;
    double cube;    // the largest coordinate of what is beside the axis
    double border;  // the centre's distance from the border's line: negative inside
    double cone;    // from the cone itself; 0 inside
    double error;   // how far a right solution may be off
} ConeView;

static ConeView view_of(const ConeJob *job)
{
    const OracleVector centre = vector_of(job->centre), axis = vector_of(job->axis);
    ConeView view = {.along = vector_dot(centre, axis), .size = fabs((double)job->radius)};
    const OracleVector beside = vector_minus(centre, vector_scaled(view.along, axis));
    view.aside = vector_length(beside);
    view.cube = fmax(fmax(fabs(beside.x), fabs(beside.y)), fabs(beside.z));
    view.border = view.aside * (double)job->cosine - view.along * (double)job->sine;
    const int is_beside = view.along * (double)job->cosine + view.aside * (double)job->sine > 0;
    view.cone = view.border <= 0 ? 0 : is_beside ? view.border : vector_length(centre);
    view.error = cone_rounding_10(job->centre, view.size);
    return view;
}

// By how much more than its size the sphere is away, by a mistake's rules.
static double gap_of(const ConeJob *job, const ConeView *view, int mistake)
{
    const double sine = job->sine, cosine = job->cosine;
    switch (mistake) {
    case CONE_NEVER:
        return -INFINITY;
    case CONE_ALWAYS:
        return INFINITY;
    case CONE_RADIUS_SIGNED:
        return view->border - (double)job->radius;
    case CONE_SINE_FOR_COSINE:
        return view->aside * sine - view->along * cosine - view->size;
    case CONE_OTHER_SIDE:
        return view->aside * cosine + view->along * sine - view->size;
    case CONE_AXIS_ONLY:
        return view->aside - view->size;
    case CONE_WITHOUT_RADIUS:
        return view->border;
    case CONE_ACROSS_AXIS:
        return view->aside - view->along * sine / cosine - view->size;
    case CONE_RADIUS_SQUARED:
        return view->border - view->size * view->size;
    case CONE_DIAMETER:
        return view->border - 2 * view->size;
    case CONE_FROM_EYE:
        return hypot(view->along, view->aside) * cosine - view->along * sine - view->size;
    case CONE_SQUARED:
        return fabs(view->border) - view->size;
    case CONE_BEHIND_MISSED:
        return view->along < 0 ? 1 : view->border - view->size;
    case CONE_BEHIND_PLANE:
        return view->along < -view->size ? 1 : view->border - view->size;
    case CONE_BY_TANGENT:
        return cosine < 0 ? view->size - view->border : view->border - view->size;
    case CONE_UNIT_CENTRE:
        return view->border / hypot(view->along, view->aside) - view->size;
    case CONE_ONLY_BEHIND:
        return -view->along - view->size;
    case CONE_UNIT_ALONG:
        return view->aside * cosine - view->along / hypot(view->along, view->aside) * sine -
               view->size;
    case CONE_CUBE:
        return view->cube * cosine - view->along * sine - view->size;
    case CONE_WITHOUT_COSINE:
        return view->aside - view->along * sine - view->size;
    case CONE_BY_DISTANCE:
        return view->aside * cosine - hypot(view->along, view->aside) * sine - view->size;
    case CONE_RADIUS_ADDED:
        return view->border + view->size;
    case CONE_HALF_RADIUS:
        return view->border - view->size / 2;
    case CONE_ALONG_SIZE:
        return hypot(view->aside, view->along - fabs(view->along)) * cosine -
               fabs(view->along) * sine - view->size;
    case CONE_BOTH_SQUARED:
        return view->aside * view->aside * cosine - view->along * sine - view->size * view->size;
    case CONE_FROM_AXIS_END:
        return hypot(view->along - 1, view->aside) * cosine - view->along * sine - view->size;
    case CONE_COSINE_SIZE:
        return view->aside * fabs(cosine) - view->along * sine - view->size;
    default:
        return view->border - view->size * (1 + cone_mistakes[mistake].share) -
               cone_mistakes[mistake].added;
    }
}

// How far off it is where the distance beside the axis comes of a difference of squares: six
// roundings of squares of the centre's distance.
static double error_by_squares(const ConeView *view)
{
    const double square = view->along * view->along + view->aside * view->aside;
    const double error = 6 * 0x1p-24 * square;
    return view->error + fmin(sqrt(error), error / view->aside);
}

static int cone_agrees(const void *pointer, int i, const void *answers, int mistake)
{
    const ConeJob *job = &((const Job10 *)pointer)->cones[i];
    const int found = ((const i32 *)answers)[i];
    const ConeView view = view_of(job);
    const double gap = gap_of(job, &view, mistake);
    if (mistake != 0) {
        const double error = mistake == CONE_BY_SQUARES ? error_by_squares(&view) : view.error;
        return fabs(gap) <= error || found == ((gap > 0) != (mistake == CONE_INVERTED));
    }
    const int may_keep = gap <= view.error || view.along <= view.error;
    const int may_miss = view.cone - view.size >= -view.error && gap >= -view.error;
    // Behind the eye an exact answer knows more than the border's line does.
    const int may_miss_behind = view.along <= 0 && view.cone - view.size >= -view.error;
    return found ? (may_miss || may_miss_behind) : may_keep;
}

// Lost digits err to either side; an epsilon, which is as small, to one alone.
static int cone_shows(const void *pointer, Range range, const void *answers, int mistake)
{
    int n_kept = 0, n_missed = 0;
    for (int i = 0; i < range.n; i++) {
        const int input = range_at(range, i);
        const int is_wrong = !cone_agrees(pointer, input, answers, 0);
        const int found = ((const i32 *)answers)[input];
        n_missed += is_wrong && found;
        n_kept += is_wrong && !found;
    }
    return mistake != CONE_BY_SQUARES || (n_kept > 0 && n_missed > 0);
}

static char *describe_cone(const void *pointer, int i, const void *answers)
{
    const ConeJob *job = &((const Job10 *)pointer)->cones[i];
    const ConeView view = view_of(job);
    const double gap = view.border - view.size;
    return message_new(
        "axis %s, sine %.6g, cosine %.6g, sphere %s radius %.9g, which is %.6g along "
        "the axis and %.6g beside it, and %.9g from the cone's border: found %d, expected %d",
        words_vec3(job->axis, 6).text, job->sine, job->cosine, words_vec3(job->centre, 6).text,
        job->radius, view.along, view.aside, view.border, ((const i32 *)answers)[i], gap > 0);
}

const Function cone_10 = {"cones",
                          N_CONES,
                          sizeof(i32),
                          COMPARED(cone_agrees, describe_cone, cone_mistakes),
                          .shows = cone_shows,
                          .knows_constant = 1};
