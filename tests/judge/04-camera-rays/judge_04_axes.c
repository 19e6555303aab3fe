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
    (void)in

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

#define IS(axis, number) is_near_04(found->axis, call.expected[number], call.error)
#define IS_OPPOSITE(axis, number) is_opposite_04(found->axis, call.expected[number], call.error)

RIGHT(are_orthonormal, not_orthonormal(&call) == NULL)
RIGHT(goes_forward, is_forward(&call))
RIGHT(are_upright, IS(right, 0) && IS(up, 1))

// ---- Mistakes -----------------------------------------------------------------------------------

// Is an axis what a mistake makes of it?
static int is_axis(Vec3 found, OracleVector axis, double error)
{
    return is_near_04(found, axis, error * fmax(1, vector_length(axis)));
}

// Of every view that was rolled.
#define ARE(right_axis, up_axis, forward_axis, times)                                              \
    (i >= FIRST_LENGTH || (is_axis(found->right, right_axis, (times) * call.error) &&              \
                           is_axis(found->up, up_axis, (times) * call.error) &&                    \
                           is_axis(found->forward, forward_axis, call.error)))
#define CROSS vector_cross
#define UNIT vector_unit
#define AT vector_of(in->at)
#define WAY vector_minus(AT, vector_of(in->from))
#define FORWARD UNIT(WAY)
#define VIEW_UP vector_of(in->up)
#define PRODUCT CROSS(FORWARD, VIEW_UP)
#define UNIT_PRODUCT CROSS(FORWARD, UNIT(VIEW_UP))
#define TO_AT UNIT(CROSS(UNIT(AT), VIEW_UP))
#define TO_Z UNIT(CROSS(FORWARD, ((OracleVector){0, 0, 1})))

#define SUM UNIT(vector_plus(AT, vector_of(in->from)))
#define TO_SUM UNIT(CROSS(SUM, VIEW_UP))
#define TO_Y UNIT(CROSS(FORWARD, ((OracleVector){0, 1, 0})))
// Forward is not made a unit vector: what comes from it is as long, or is made a unit vector.
#define LONG_FORWARD "forward is not made a unit vector"
#define LONG_PRODUCT CROSS(WAY, VIEW_UP)

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

    EACH(at_for_way, ARE(TO_AT, CROSS(TO_AT, UNIT(AT)), UNIT(AT), 1),
         "forward is the way to `at` from the origin, not from the eye");
    EACH(sum_for_way, ARE(TO_SUM, CROSS(TO_SUM, SUM), SUM, 8),
         "forward is `at` minus `from`, not plus");
    // A cross product with z loses digits where the view is nearly along it.
    EACH(z_for_up, ARE(TO_Z, CROSS(TO_Z, FORWARD), FORWARD, 64),
         "view.up is not asked: z was taken for it");
    EACH(y_for_up, ARE(TO_Y, CROSS(TO_Y, FORWARD), FORWARD, 64),
         "view.up is not asked: y was taken for it");
    EACH(up_from_view_up, ARE(UNIT(PRODUCT), CROSS(UNIT(PRODUCT), VIEW_UP), FORWARD, 1),
         "up was computed from right and view.up: it comes from right and forward");
    EACH(unit_vectors, ARE(UNIT_PRODUCT, CROSS(UNIT_PRODUCT, FORWARD), FORWARD, 1),
         "of two unit vectors that are not at right angles the cross product is shorter than 1: "
         "right is to be made a unit vector");
    EACH(long_right, ARE(PRODUCT, CROSS(PRODUCT, FORWARD), FORWARD, 1),
         "right is not made a unit vector, and up comes from it");
    EACH(right_alone_long, ARE(PRODUCT, UNIT(CROSS(PRODUCT, FORWARD)), FORWARD, 1),
         "right is not made a unit vector");
    EACH(right_late, ARE(UNIT(PRODUCT), CROSS(PRODUCT, FORWARD), FORWARD, 1),
         "right was made a unit vector only after up had come from it");
    EACH(forward_long, ARE(UNIT(PRODUCT), CROSS(UNIT(PRODUCT), WAY), WAY, 1), LONG_FORWARD);
    EACH(forward_alone_long, ARE(UNIT(PRODUCT), UNIT(CROSS(PRODUCT, FORWARD)), WAY, 1),
         LONG_FORWARD);
    EACH(none_unit, ARE(LONG_PRODUCT, CROSS(LONG_PRODUCT, WAY), WAY, 1),
         "none of the three is made a unit vector");
    EACH(up_as_given, ARE(UNIT(PRODUCT), VIEW_UP, FORWARD, 1),
         "up is view.up, which need be neither a unit vector nor at right angles to forward");
    EACH(up_made_unit, ARE(UNIT(PRODUCT), UNIT(VIEW_UP), FORWARD, 1),
         "up is view.up, which need not be at right angles to forward");
    EACH(up_from_way,
         ARE(UNIT(PRODUCT),
             UNIT(vector_minus(VIEW_UP, vector_scaled(vector_dot(VIEW_UP, WAY), FORWARD))), FORWARD,
             1),
         "up lost its part along a forward that is not yet a unit vector");

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

    ONLY(backwards, IS_OPPOSITE(forward, 2), "forward points backwards");
    return NO_MORE;
}

KNOWN_LIST(known_of_up)
{
    GIVEN;

    ONLY(right_of_backwards, IS_OPPOSITE(forward, 2) && IS_OPPOSITE(right, 0),
         "right comes from forward, which points backwards");
    ONLY(right_to_left, IS_OPPOSITE(right, 0),
         "right points to the left: mind the order of the cross product");
    ONLY(up_is_down, IS_OPPOSITE(up, 1), "up points down: mind the order of the cross product");
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
    return describe(&call,
                    IS_OPPOSITE(forward, 2) ? "" : ": forward does not go from `from` to `at`");
}

static char *describe_up(const void *job, int i, const void *answers)
{
    GIVEN;
    return describe(&call, IS_OPPOSITE(right, 0) || IS_OPPOSITE(up, 1) ? ""
                           : IS(right, 0)
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
