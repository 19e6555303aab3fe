// Lab 04: camera_axes on the job's views. See judge_04.h; judge_04_rays.c is the sibling.
//
// What is expected comes from oracle3d.h, in double precision.
#include "judge_04.h"

#include "message.h"
#include "words.h"

#include <math.h>

// How far a right solution's axes may be off where view.up is at right angles to the view: a
// difference, two cross products and two normalisations in float, each of few roundings of 2^-24.
// The cross product with `up` loses as many digits more as the sine of the angle between the two is
// small; roll_view() has a lowest one of 1/4, for which the bound of all its views stands.
#define AXES_ERROR (16 * 0x1p-24)
#define LOWEST_SINE 0.25

typedef struct Axes {
    Vec3 right, up, forward;
} Axes;

// ---- Right --------------------------------------------------------------------------------------

static double dot(Vec3 a, OracleVector b)
{
    return vector_dot(vector_of(a), b);
}

// One call of camera_axes.
typedef struct AxesCall {
    const ViewJob *view;
    Axes found;
    OracleVector expected[3];
    double error;  // how far each of the axes may be off
} AxesCall;

static AxesCall axes_call(const Job04 *job, int i, const Axes *answers)
{
    AxesCall call = {.view = &job->views[i], .found = answers[i]};
    const View view = {.from = call.view->from, .at = call.view->at, .up = call.view->up};
    oracle3d_axes(&view, call.expected);
    // The axis up is view.up without its part along forward: that is as long as the sine.
    const double sine = dot(view.up, call.expected[1]) / vec3_length(view.up);
    call.error = AXES_ERROR / fmin(sine, LOWEST_SINE);
    return call;
}

static int is_unit(const AxesCall *call, Vec3 v)
{
    return fabs(vec3_length(v) - 1) <= call->error;
}

// Is a unit vector at right angles to b?
static int is_across(const AxesCall *call, Vec3 a, Vec3 b)
{
    return fabs(dot(a, vector_of(b))) <= call->error * vec3_length(b);
}

#define GIVEN                                                                                      \
    const AxesCall call = axes_call(job, i, answers);                                              \
    const ViewJob *in = call.view;                                                                 \
    const Axes *found = &call.found;                                                               \
    (void)in, (void)found

// As it joins what was found; NULL where all is right.
static const char *not_orthonormal(const AxesCall *call)
{
    const Axes *found = &call->found;
    return !is_unit(call, found->forward) || !is_unit(call, found->right) ||
                   !is_unit(call, found->up)
               ? ": not all three are unit vectors"
           : !is_across(call, found->forward, found->right) ||
                   !is_across(call, found->up, found->right)
               ? ": right is not at right angles to the others"
           : !is_across(call, found->forward, found->up) ? ": up is not at right angles to forward"
           : !is_across(call, found->right, call->view->up)
               ? ": right is not at right angles to view.up"
               : NULL;
}

// Of any length: that is the business of the check above.
static int is_forward(const AxesCall *call)
{
    const double length = vec3_length(call->found.forward);
    return length > 0 && is_near_04(call->found.forward, vector_scaled(length, call->expected[2]),
                                    call->error * length);
}

// Is this axis right, number 0 to 2; or does it point the other way?
static int is_expected(const AxesCall *call, Vec3 axis, int number)
{
    return is_near_04(axis, call->expected[number], call->error);
}

static int is_opposite(const AxesCall *call, Vec3 axis, int number)
{
    return is_opposite_04(axis, call->expected[number], call->error);
}

RIGHT(are_orthonormal, not_orthonormal(&call) == NULL)
RIGHT(goes_forward, is_forward(&call))
RIGHT(are_upright, is_expected(&call, found->right, 0) && is_expected(&call, found->up, 1))

// ---- Mistakes -----------------------------------------------------------------------------------

// Is an axis what a mistake makes of it?
static int is_axis(Vec3 found, OracleVector axis, double error)
{
    return is_near_04(found, axis, error * fmax(1, vector_length(axis)));
}

// Are these the axes of every view that was rolled? Those across the view may be off by more.
static int are_axes(const AxesCall *call, OracleVector right, OracleVector up, OracleVector forward,
                    double times)
{
    return is_axis(call->found.right, right, times * call->error) &&
           is_axis(call->found.up, up, times * call->error) &&
           is_axis(call->found.forward, forward, call->error);
}

#define ARE(name, right, up, forward, times, ...)                                                  \
    EACH(name, i >= FIRST_LENGTH || are_axes(&call, right, up, forward, times), __VA_ARGS__)

// Forward is not made a unit vector: what comes from it is as long, or is made a unit vector.
#define LONG_FORWARD "forward is not made a unit vector"

// Is an axis zero, infinite or no number?
static int has_left_range(Axes axes)
{
    const double product =
        (double)vec3_length(axes.right) * vec3_length(axes.up) * vec3_length(axes.forward);
    return !isfinite(product) || product == 0;
}

// Of some view along long or short vectors?
static int some_have_left_range(const Axes *answers)
{
    int have_left = 0;
    for (int i = FIRST_LENGTH; i < FIRST_STEEP; i++) {
        have_left |= has_left_range(answers[i]);
    }
    return have_left;
}

KNOWN_LIST(known_of_all)
{
    GIVEN;
    const OracleVector way_to = vector_minus(vector_of(in->at), vector_of(in->from));
    const OracleVector at = vector_unit(vector_of(in->at));
    const OracleVector view_up = vector_of(in->up);
    const OracleVector sum = vector_unit(vector_plus(vector_of(in->at), vector_of(in->from)));
    const OracleVector forward = vector_unit(way_to);
    const OracleVector product = vector_cross(forward, view_up), right = vector_unit(product);
    const OracleVector of_units = vector_cross(forward, vector_unit(view_up));
    const OracleVector of_way = vector_cross(way_to, view_up);
    const OracleVector to_at = vector_unit(vector_cross(at, view_up));
    const OracleVector to_sum = vector_unit(vector_cross(sum, view_up));
    const OracleVector to_z = vector_unit(vector_cross(forward, (OracleVector){0, 0, 1}));
    const OracleVector to_y = vector_unit(vector_cross(forward, (OracleVector){0, 1, 0}));

    ARE(at_for_way, to_at, vector_cross(to_at, at), at, 1,
        "forward is the way to `at` from the origin, not from the eye");
    ARE(sum_for_way, to_sum, vector_cross(to_sum, sum), sum, 8,
        "forward is `at` minus `from`, not plus");
    // A cross product with z loses digits where the view is nearly along it.
    ARE(z_for_up, to_z, vector_cross(to_z, forward), forward, 64,
        "view.up is not asked: z was taken for it");
    ARE(y_for_up, to_y, vector_cross(to_y, forward), forward, 64,
        "view.up is not asked: y was taken for it");
    ARE(up_from_view_up, right, vector_cross(right, view_up), forward, 1,
        "up was computed from right and view.up: it comes from right and forward");
    ARE(unit_vectors, of_units, vector_cross(of_units, forward), forward, 1,
        "of two unit vectors that are not at right angles the cross product is shorter than 1: "
        "right is to be made a unit vector");
    ARE(long_right, product, vector_cross(product, forward), forward, 1,
        "right is not made a unit vector, and up comes from it");
    ARE(right_alone_long, product, vector_unit(vector_cross(product, forward)), forward, 1,
        "right is not made a unit vector");
    ARE(right_late, right, vector_cross(product, forward), forward, 1,
        "right was made a unit vector only after up had come from it");
    ARE(forward_long, right, vector_cross(right, way_to), way_to, 1, LONG_FORWARD);
    ARE(forward_alone_long, right, vector_unit(vector_cross(product, forward)), way_to, 1,
        LONG_FORWARD);
    ARE(none_unit, of_way, vector_cross(of_way, way_to), way_to, 1,
        "none of the three is made a unit vector");
    ARE(up_as_given, right, view_up, forward, 1,
        "up is view.up, which need be neither a unit vector nor at right angles to forward");
    ARE(up_made_unit, right, vector_unit(view_up), forward, 1,
        "up is view.up, which need not be at right angles to forward");
    ARE(up_from_way, right,
        vector_unit(vector_minus(view_up, vector_scaled(vector_dot(view_up, way_to), forward))),
        forward, 1, "up lost its part along a forward that is not yet a unit vector");

    ONLY(steep, i >= FIRST_STEEP,
         "other views are right, and any angle to up counts, however small");
    ONLY(out_of_range, i >= FIRST_LENGTH && some_have_left_range(answers),
         "views of usual length are right, but squares and products of numbers as large or small "
         "as these leave float's range");
    ONLY(of_length, i >= FIRST_LENGTH, "views of usual length are right, and any length counts");
    return NO_MORE;
}

KNOWN_LIST(known_of_forward)
{
    GIVEN;

    ONLY(backwards, is_opposite(&call, found->forward, 2), "forward points backwards");
    return NO_MORE;
}

KNOWN_LIST(known_of_up)
{
    GIVEN;

    ONLY(right_of_backwards,
         is_opposite(&call, found->forward, 2) && is_opposite(&call, found->right, 0),
         "right comes from forward, which points backwards");
    ONLY(right_to_left, is_opposite(&call, found->right, 0),
         "right points to the left: mind the order of the cross product");
    ONLY(up_is_down, is_opposite(&call, found->up, 1),
         "up points down: mind the order of the cross product");
    return NO_MORE;
}

// ---- Answers ------------------------------------------------------------------------------------

//   remark   joins what was found
static char *describe(const AxesCall *call, const char *remark)
{
    const ViewJob *view = call->view;
    const Axes *found = &call->found;
    const OracleVector *e = call->expected;
    return message_new(
        "view from %s at %s up %s: found right %s, up %s, forward %s, expected right %s, up %s, "
        "forward %s%s",
        words_vec3(view->from, 6).text, words_vec3(view->at, 6).text, words_vec3(view->up, 6).text,
        words_vec3(found->right, 4).text, words_vec3(found->up, 4).text,
        words_vec3(found->forward, 4).text, words_xyz(e[0].x, e[0].y, e[0].z, 4).text,
        words_xyz(e[1].x, e[1].y, e[1].z, 4).text, words_xyz(e[2].x, e[2].y, e[2].z, 4).text,
        remark);
}

static char *describe_lengths(const void *job, int i, const void *answers)
{
    const AxesCall call = axes_call(job, i, answers);
    return describe(&call, not_orthonormal(&call));
}

static char *describe_forward(const void *job, int i, const void *answers)
{
    GIVEN;
    return describe(&call, is_opposite(&call, found->forward, 2)
                               ? ""
                               : ": forward does not go from `from` to `at`");
}

static char *describe_up(const void *job, int i, const void *answers)
{
    GIVEN;
    return describe(&call, is_opposite(&call, found->right, 0) || is_opposite(&call, found->up, 1)
                               ? ""
                           : is_expected(&call, found->right, 0)
                               ? ": up is not what is left of view.up at right angles to forward"
                               : ": right is not forward x up");
}

const Function axes_orthonormal_04 = {"axes",
                                      N_VIEWS,
                                      sizeof(Axes),
                                      KNOWING(are_orthonormal, describe_lengths, known_of_all),
                                      .counted = "views",
                                      .knows_constant = 1};
const Function axes_forward_04 = {
    "axes",
    N_VIEWS,
    sizeof(Axes),
    KNOWING(goes_forward, describe_forward, known_of_all, known_of_forward),
    .counted = "views",
    .knows_constant = 1};
const Function axes_up_04 = {"axes",
                             N_VIEWS,
                             sizeof(Axes),
                             KNOWING(are_upright, describe_up, known_of_all, known_of_up),
                             .counted = "views",
                             .knows_constant = 1};
