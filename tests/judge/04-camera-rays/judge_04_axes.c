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

// ---- Known mistakes -----------------------------------------------------------------------------

// A way of making the axes, each from its own way of the step that its name tells.
typedef struct AxesMistake {
    const char *says;
    int at_for_way;      // forward: the point looked at for the way to it
    int z_for_up;        // z for view.up
    int unit_up;         // view.up made a unit vector, and its cross product left as long as it is
    int long_right;      // right as long as the cross product
    int right_late;      // the same for up only
    int up_is_view_up;   // view.up for up,
    int up_is_unit;      // made a unit vector
    int up_is_from_raw;  // view.up without its part along the way, which is no unit vector
} AxesMistake;

static const AxesMistake axes_mistakes[] = {
    {"forward is the way to `at` from the origin, not from the eye", .at_for_way = 1},
    {"view.up is not asked: z was taken for it", .z_for_up = 1},
    {"of two unit vectors that are not at right angles the cross product is shorter than 1: right "
     "is to be made a unit vector",
     .unit_up = 1, .long_right = 1},
    {"right is not made a unit vector, and up comes from it", .long_right = 1},
    {"right was made a unit vector only after up had come from it", .right_late = 1},
    {"up is view.up, which need be neither a unit vector nor at right angles to forward",
     .up_is_view_up = 1},
    {"up is view.up, which need not be at right angles to forward", .up_is_view_up = 1,
     .up_is_unit = 1},
    {"up lost its part along a forward that is not yet a unit vector", .up_is_from_raw = 1},
};

static void mistaken_axes(const ViewJob *view, const AxesMistake *mistake, OracleVector axes[3])
{
    const OracleVector z = {0, 0, 1}, at = vector_of(view->at);
    const OracleVector way = mistake->at_for_way ? at : vector_minus(at, vector_of(view->from));
    const OracleVector forward = vector_unit(way);
    const OracleVector given = mistake->z_for_up ? z : vector_of(view->up);
    const OracleVector view_up = mistake->unit_up ? vector_unit(given) : given;
    const OracleVector product = vector_cross(forward, view_up), right = vector_unit(product);
    const double along = vector_dot(view_up, way);
    axes[0] = mistake->long_right ? product : right;
    axes[1] =
        mistake->up_is_from_raw  ? vector_unit(vector_minus(view_up, vector_scaled(along, forward)))
        : mistake->up_is_unit    ? vector_unit(view_up)
        : mistake->up_is_view_up ? view_up
                                 : vector_cross(mistake->right_late ? product : axes[0], forward);
    axes[2] = forward;
}

// ---- One call -----------------------------------------------------------------------------------

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

// What is said of wrong axes: a remark on what was found, or what it looks like. Neither where
// nothing is wrong.
typedef struct AxesFault {
    const char *remark;  // ": right is not forward x up"
    const char *looks;   // "forward points backwards"
} AxesFault;
typedef AxesFault JudgeAxes(const AxesCall *call);

static AxesFault not_orthonormal(const AxesCall *call)
{
    const Axes *found = &call->found;
    const char *remark =
        !is_unit(call, found->forward) || !is_unit(call, found->right) || !is_unit(call, found->up)
            ? ": not all three are unit vectors"
        : !is_across(call, found->forward, found->right) ||
                !is_across(call, found->up, found->right)
            ? ": right is not at right angles to the others"
        : !is_across(call, found->forward, found->up) ? ": up is not at right angles to forward"
        : !is_across(call, found->right, call->view->up)
            ? ": right is not at right angles to view.up"
            : NULL;
    return (AxesFault){.remark = remark};
}

// Of any length: that is the business of the check above.
static AxesFault not_forward(const AxesCall *call)
{
    const Vec3 found = call->found.forward;
    const double length = vec3_length(found);
    const OracleVector f = call->expected[2], wanted = {length * f.x, length * f.y, length * f.z};
    if (is_near_04(found, wanted, call->error * length) && length > 0) {
        return (AxesFault){0};
    }
    if (is_opposite_04(found, f, call->error)) {
        return (AxesFault){.looks = "forward points backwards"};
    }
    return (AxesFault){.remark = ": forward does not go from `from` to `at`"};
}

static AxesFault not_upright(const AxesCall *call)
{
    const Axes *found = &call->found;
    const OracleVector *expected = call->expected;
    const int is_right = is_near_04(found->right, expected[0], call->error);
    const int is_up = is_near_04(found->up, expected[1], call->error);
    if (is_right && is_up) {
        return (AxesFault){0};
    }
    if (is_opposite_04(found->right, expected[0], call->error)) {
        return (AxesFault){.looks =
                               "right points to the left: mind the order of the cross product"};
    }
    if (is_opposite_04(found->up, expected[1], call->error)) {
        return (AxesFault){.looks = "up points down: mind the order of the cross product"};
    }
    return (AxesFault){
        .remark = is_right ? ": up is not what is left of view.up at right angles to forward"
                           : ": right is not forward x up"};
}

// Is an axis what a mistake makes of it?
static int is_mistaken(Vec3 found, OracleVector axis, double error)
{
    return is_near_04(found, axis, error * fmax(1, vector_length(axis)));
}

// The mistake that explains the axes of every view that was rolled, or NULL.
static const char *recognised(const Job04 *job, const Axes *answers)
{
    for (int m = 0; m < COUNT(axes_mistakes); m++) {
        int i = 0, agrees = 1;
        for (; agrees && i < FIRST_LENGTH; i++) {
            OracleVector axes[3];
            mistaken_axes(&job->views[i], &axes_mistakes[m], axes);
            const double error = axes_call(job, i, answers).error;
            // A cross product with z loses digits where the view is nearly along it.
            const double lost = axes_mistakes[m].z_for_up ? 64 * error : error;
            agrees = is_mistaken(answers[i].right, axes[0], lost) &&
                     is_mistaken(answers[i].up, axes[1], lost) &&
                     is_mistaken(answers[i].forward, axes[2], error);
        }
        if (agrees) {
            return axes_mistakes[m].says;
        }
    }
    return NULL;
}

// Is an axis zero, infinite or no number?
static int has_left_range(const Axes *found)
{
    const Vec3 axes[3] = {found->right, found->up, found->forward};
    for (int i = 0; i < 3; i++) {
        if (!isfinite(vec3_length(axes[i])) || vec3_length(axes[i]) == 0) {
            return 1;
        }
    }
    return 0;
}

// What is special about view number i where all before it are right; else NULL.
static const char *special_looks(int i, const Axes *found)
{
    return i >= FIRST_STEEP   ? "other views are right, and any angle to up counts, however small"
           : i < FIRST_LENGTH ? NULL
           : has_left_range(found)
               ? "views of usual length are right, but squares and products of numbers as large "
                 "or small as these leave float's range"
               : "views of usual length are right, and any length counts";
}

static Diagnosis axes_fault(const void *job, int i, const void *answers, JudgeAxes *judge)
{
    const AxesCall call = axes_call(job, i, answers);
    const ViewJob *view = call.view;
    const Axes *found = &call.found;
    const OracleVector *e = call.expected;
    AxesFault fault = judge(&call);
    if (fault.remark == NULL && fault.looks == NULL) {
        return NOTHING_WRONG;
    }
    const char *special = special_looks(i, found);
    const char *mistake = special == NULL ? recognised(job, answers) : NULL;
    if (special != NULL) {
        fault = (AxesFault){.looks = special};
    } else if (mistake != NULL) {
        fault.looks = mistake;
    }
    char *wrong = message_new(
        "view from %s at %s up %s: found right %s, up %s, forward %s, expected right %s, up %s, "
        "forward %s%s",
        words_vec3(view->from, 6).text, words_vec3(view->at, 6).text, words_vec3(view->up, 6).text,
        words_vec3(found->right, 4).text, words_vec3(found->up, 4).text,
        words_vec3(found->forward, 4).text, words_xyz(e[0].x, e[0].y, e[0].z, 4).text,
        words_xyz(e[1].x, e[1].y, e[1].z, 4).text, words_xyz(e[2].x, e[2].y, e[2].z, 4).text,
        fault.remark != NULL ? fault.remark : "");
    return diagnosis_of(wrong, (Cause){.says = fault.looks});
}

static Diagnosis orthonormal_fault(const void *job, int i, const void *answers)
{
    return axes_fault(job, i, answers, not_orthonormal);
}

static Diagnosis forward_fault(const void *job, int i, const void *answers)
{
    return axes_fault(job, i, answers, not_forward);
}

static Diagnosis upright_fault(const void *job, int i, const void *answers)
{
    return axes_fault(job, i, answers, not_upright);
}

const Function axes_orthonormal_04 = {"axes", N_VIEWS, sizeof(Axes), .fault = orthonormal_fault};
const Function axes_forward_04 = {"axes", N_VIEWS, sizeof(Axes), .fault = forward_fault};
const Function axes_up_04 = {"axes", N_VIEWS, sizeof(Axes), .fault = upright_fault};
