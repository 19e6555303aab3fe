// Lab 05: each function on its inputs. See judge_05_inputs.h.
//
// Every function has a list of known mistakes, as rules of the oracle; a wrong answer's cause is
// named when one mistake explains all wrong answers of the range.
#include "judge_05_inputs.h"

#include "message.h"
#include "oracle3d.h"

#include <math.h>
#include <string.h>

#define COUNT(array) ((int)(sizeof(array) / sizeof *(array)))

static const OracleRules3D right = {0};

// A known mistake, and what is said about it.
typedef struct Mistake {
    const char *says;
    OracleRules3D rules;
} Mistake;

// Does an answer agree with what a way of tracing gives for input i?
typedef int Agrees(const Inputs05 *inputs, int i, const void *answers, const OracleRules3D *rules);

// The answers of one function in one range, held against the oracle.
typedef struct Range {
    const Inputs05 *inputs;
    const void *answers;
    size_t answer_bytes;
    int first, n;
    Agrees *agrees;
    const Mistake *mistakes;
    int n_mistakes;
} Range;

// What went wrong in a range.
typedef struct Wrong {
    int n;            // wrong answers
    int first;        // the first wrong input
    const char *why;  // the mistake that explains all of them; "" when none does
    int is_constant;  // all answers are the same
} Wrong;

static int explains(const Range *range, const OracleRules3D *rules)
{
    for (int i = range->first; i < range->first + range->n; i++) {
        if (!range->agrees(range->inputs, i, range->answers, rules)) {
            return 0;
        }
    }
    return 1;
}

// Are all answers the same, as where nothing was filled in? Then nothing is concluded from them.
static int is_constant(const Range *range)
{
    const char *answers = (const char *)range->answers + (size_t)range->first * range->answer_bytes;
    int i = 1;
    while (i < range->n &&
           memcmp(answers, answers + (size_t)i * range->answer_bytes, range->answer_bytes) == 0) {
        i++;
    }
    return i == range->n;
}

static Wrong range_judge(const Range *range)
{
    Wrong wrong = {.why = "", .is_constant = is_constant(range)};
    for (int i = range->first + range->n - 1; i >= range->first; i--) {
        if (!range->agrees(range->inputs, i, range->answers, &right)) {
            wrong.n++;
            wrong.first = i;
        }
    }
    const int n_mistakes = wrong.n == 0 || wrong.is_constant ? 0 : range->n_mistakes;
    for (int i = 0; i < n_mistakes; i++) {
        if (explains(range, &range->mistakes[i].rules)) {
            wrong.why = range->mistakes[i].says;
            break;
        }
    }
    return wrong;
}

static const Mistake root_mistakes[] = {
    {"; that is the farther root, where the ray leaves the sphere", {.farther_root = 1}},
    {"; that is not beyond t_min", {.any_distance = 1}},
    {"; from inside the second root is the hit: b + sqrt(disc)", {.inside_is_miss = 1}},
    {"; a negative radius means that only the farther root counts", {.radius_sign_ignored = 1}},
    {"; a sphere with a negative radius is seen from inside", {.negative_radius_missed = 1}},
};

// ---- nearest_root

// The roots, on a ray of their own: the sphere's centre is at distance b, half a chord of it is the
// radius. What nearest_root gets is exact; its root is not quite.
static OracleRoot expected_root(RootJob job, const OracleRules3D *rules)
{
    const float half_chord = sqrtf(job.disc);
    const Sphere sphere = {job.b, 0, 0, job.radius < 0 ? -half_chord : half_chord};
    OracleRay ray = {.direction = {1, 0, 0}, .t_min = job.t_min};
    OracleRoot miss = {.t = INFINITY};
    return job.disc < 0 ? miss : oracle3d_root(sphere, &ray, ORACLE_PROJECTION, rules);
}

static int is_right_root(const OracleRoot *root, float found)
{
    if (isinf(found) && found > 0) {
        return !root->is_certain;
    }
    return root->is_possible && found >= root->t_low && found <= root->t_high;
}

static int root_agrees(const Inputs05 *inputs, int i, const void *answers,
                       const OracleRules3D *rules)
{
    const RootJob job = inputs->roots[i];
    const float found = ((const float *)answers)[i];
    if (job.disc == 0) {
        // Exact in float, too: the one root is b, and a hit where it is beyond t_min.
        const int is_hit = job.b > job.t_min || rules->any_distance;
        return is_hit ? found == job.b : isinf(found) && found > 0;
    }
    const OracleRoot root = expected_root(job, rules);
    return is_right_root(&root, found);
}

Verdict inputs_05_judge_roots(const Inputs05 *inputs, int range, const Sections *answers)
{
    const float *found =
        sections_find(answers, "roots", sizeof(float) * (size_t)COUNT(inputs->roots));
    if (found == NULL) {
        return verdict_missing;
    }
    const Wrong wrong =
        range_judge(&(Range){inputs, found, sizeof *found, range * N_ROOT_INPUTS, N_ROOT_INPUTS,
                             root_agrees, root_mistakes, COUNT(root_mistakes)});
    if (wrong.n == 0) {
        return verdict_of(NULL);
    }
    const RootJob job = inputs->roots[wrong.first];
    const double expected = job.disc != 0       ? expected_root(job, &right).t
                            : job.b > job.t_min ? (double)job.b
                                                : (double)INFINITY;
    return verdict_of(message_new(
        "b %g, disc %g, radius %g, t_min %g: found %.7g, expected %.7g (%d of %d inputs are "
        "wrong)%s",
        (double)job.b, (double)job.disc, (double)job.radius, (double)job.t_min,
        (double)found[wrong.first], expected, wrong.n, N_ROOT_INPUTS, wrong.why));
}

// ---- intersect_textbook, intersect_sphere

static OracleRoot expected_hit(const SphereRayJob *job, OracleForm form, const OracleRules3D *rules)
{
    const OracleRay ray = oracle3d_given_ray(job->origin, job->direction, job->t_min);
    return oracle3d_root(job->sphere, &ray, form, rules);
}

static int textbook_agrees(const Inputs05 *inputs, int i, const void *answers,
                           const OracleRules3D *rules)
{
    const OracleRoot root = expected_hit(&inputs->textbook[i], ORACLE_TEXTBOOK, rules);
    return is_right_root(&root, ((const float *)answers)[i]);
}

static int projection_agrees(const Inputs05 *inputs, int i, const void *answers,
                             const OracleRules3D *rules)
{
    const OracleRoot root = expected_hit(&inputs->projection[i], ORACLE_PROJECTION, rules);
    return is_right_root(&root, ((const float *)answers)[i]);
}

static char *describe_sphere(const SphereRayJob *job, float found, double expected, Wrong wrong)
{
    return message_new(
        "sphere at (%g, %g, %g) radius %g, ray from (%g, %g, %g) along (%.7g, %.7g, %.7g): found "
        "%.9g, expected %.9g (%d of %d inputs are wrong)%s",
        (double)job->sphere.x, (double)job->sphere.y, (double)job->sphere.z,
        (double)job->sphere.radius, (double)job->origin.x, (double)job->origin.y,
        (double)job->origin.z, (double)job->direction.x, (double)job->direction.y,
        (double)job->direction.z, (double)found, expected, wrong.n, N_SPHERE_INPUTS, wrong.why);
}

Verdict inputs_05_judge_textbook(const Inputs05 *inputs, int range, const Sections *answers)
{
    const float *found =
        sections_find(answers, "textbook", sizeof(float) * (size_t)COUNT(inputs->textbook));
    if (found == NULL) {
        return verdict_missing;
    }
    const Wrong wrong =
        range_judge(&(Range){inputs, found, sizeof *found, range * N_SPHERE_INPUTS, N_SPHERE_INPUTS,
                             textbook_agrees, root_mistakes, COUNT(root_mistakes)});
    if (wrong.n == 0) {
        return verdict_of(NULL);
    }
    const SphereRayJob *job = &inputs->textbook[wrong.first];
    return verdict_of(describe_sphere(job, found[wrong.first],
                                      expected_hit(job, ORACLE_TEXTBOOK, &right).t, wrong));
}

// Would the textbook's form explain the answers?
static int is_textbook(const Inputs05 *inputs, int first, const float *found)
{
    for (int i = first; i < first + N_SPHERE_INPUTS; i++) {
        const OracleRoot root = expected_hit(&inputs->projection[i], ORACLE_TEXTBOOK, &right);
        if (!is_right_root(&root, found[i])) {
            return 0;
        }
    }
    return 1;
}

Verdict inputs_05_judge_projection(const Inputs05 *inputs, int range, const Sections *answers)
{
    const float *found =
        sections_find(answers, "projection", sizeof(float) * (size_t)COUNT(inputs->projection));
    if (found == NULL) {
        return verdict_missing;
    }
    const int first = range * N_SPHERE_INPUTS;
    Wrong wrong = range_judge(&(Range){inputs, found, sizeof *found, first, N_SPHERE_INPUTS,
                                       projection_agrees, root_mistakes, COUNT(root_mistakes)});
    if (wrong.n == 0) {
        return verdict_of(NULL);
    }
    if (wrong.why[0] == '\0' && !wrong.is_constant && is_textbook(inputs, first, found)) {
        wrong.why = "; the digits are lost: the textbook's form, or one like it, which squares "
                    "before it subtracts";
    }
    const SphereRayJob *job = &inputs->projection[wrong.first];
    return verdict_of(describe_sphere(job, found[wrong.first],
                                      expected_hit(job, ORACLE_PROJECTION, &right).t, wrong));
}

// ---- surface_normal, shade

static int is_near(Vec3 found, OracleNear expected)
{
    return fabs(found.x - expected.value.x) <= expected.error &&
           fabs(found.y - expected.value.y) <= expected.error &&
           fabs(found.z - expected.value.z) <= expected.error;
}

static OracleNear exactly(Vec3 v)
{
    return (OracleNear){{v.x, v.y, v.z}, 0};
}

static OracleNear expected_normal(NormalJob job, const OracleRules3D *rules)
{
    return oracle3d_normal(job.sphere, exactly(job.point), exactly(job.direction), rules);
}

static int normal_agrees(const Inputs05 *inputs, int i, const void *answers,
                         const OracleRules3D *rules)
{
    return is_near(((const Vec3 *)answers)[i], expected_normal(inputs->normals[i], rules));
}

Verdict inputs_05_judge_normals(const Inputs05 *inputs, int range, const Sections *answers)
{
    static const Mistake mistakes[] = {
        {"; it is not a unit vector", {.normal_not_normalised = 1}},
        {"; it is not a unit vector, and points away from the eye",
         {.normal_not_normalised = 1, .normal_not_turned = 1}},
        {"; seen from inside it must be turned, towards the eye", {.normal_not_turned = 1}},
        {"; it points to the centre, not away from it", {.normal_always_turned = 1}},
        {"; it points away from where the ray comes from", {.normal_turned_away = 1}},
    };
    const Vec3 *found =
        sections_find(answers, "normals", sizeof *found * (size_t)COUNT(inputs->normals));
    if (found == NULL) {
        return verdict_missing;
    }
    const Wrong wrong =
        range_judge(&(Range){inputs, found, sizeof *found, range * N_NORMAL_INPUTS, N_NORMAL_INPUTS,
                             normal_agrees, mistakes, COUNT(mistakes)});
    if (wrong.n == 0) {
        return verdict_of(NULL);
    }
    const NormalJob job = inputs->normals[wrong.first];
    const Vec3 own = found[wrong.first];
    const OracleVector expected = expected_normal(job, &right).value;
    return verdict_of(message_new(
        "sphere at (%g, %g, %g) radius %g, point (%g, %g, %g), direction (%g, %g, %g): found "
        "(%.5g, %.5g, %.5g), expected (%.5g, %.5g, %.5g) (%d of %d inputs are wrong)%s",
        (double)job.sphere.x, (double)job.sphere.y, (double)job.sphere.z, (double)job.sphere.radius,
        (double)job.point.x, (double)job.point.y, (double)job.point.z, (double)job.direction.x,
        (double)job.direction.y, (double)job.direction.z, (double)own.x, (double)own.y,
        (double)own.z, expected.x, expected.y, expected.z, wrong.n, N_NORMAL_INPUTS, wrong.why));
}

static OracleNear expected_shade(const Inputs05 *inputs, int i, const OracleRules3D *rules)
{
    const ShadeJob *job = &inputs->shades[i];
    return oracle3d_shade(exactly(job->point), exactly(job->normal), &job->material,
                          inputs->lights + job->first_light, job->n_lights, rules);
}

static int shade_agrees(const Inputs05 *inputs, int i, const void *answers,
                        const OracleRules3D *rules)
{
    return is_near(((const Vec3 *)answers)[i], expected_shade(inputs, i, rules));
}

Verdict inputs_05_judge_shades(const Inputs05 *inputs, int range, const Sections *answers)
{
    static const Mistake mistakes[] = {
        {"; a light behind the surface takes light away: a negative cosine counts as 0",
         {.cosine_not_clamped = 1}},
        {"; a light behind the surface lights it: a negative cosine counts as 0",
         {.cosine_absolute = 1}},
        {"; the way to the light is not made a unit vector", {.to_light_not_normalised = 1}},
        {"; that is the first light's share only", {.first_light_only = 1}},
        {"; that is the last light's share only", {.last_light_only = 1}},
        {"; one light too many shines, the one behind the end of the array", {.one_light_more = 1}},
        {"; kd is missing", {.ignore_kd = 1}},
        {"; the material's colour is missing", {.ignore_color = 1}},
        {"; the light's colour is missing", {.ignore_light_color = 1}},
        {"; that is right with red and blue swapped", {.red_blue_swapped = 1}},
        {"; that is right but for gamma: the colour was raised to 1 / 2.2, but it is linear here",
         {.gamma = 1 / 2.2}},
        {"; that is right but for gamma: the colour was raised to 2.2, but it is linear here",
         {.gamma = 2.2}},
    };
    const Vec3 *found =
        sections_find(answers, "shades", sizeof *found * (size_t)COUNT(inputs->shades));
    if (found == NULL) {
        return verdict_missing;
    }
    const Wrong wrong =
        range_judge(&(Range){inputs, found, sizeof *found, range * N_SHADE_INPUTS, N_SHADE_INPUTS,
                             shade_agrees, mistakes, COUNT(mistakes)});
    if (wrong.n == 0) {
        return verdict_of(NULL);
    }
    const ShadeJob *job = &inputs->shades[wrong.first];
    const Vec3 own = found[wrong.first];
    const OracleVector expected = expected_shade(inputs, wrong.first, &right).value;
    const Light light = inputs->lights[job->first_light];
    return verdict_of(message_new(
        "point (%g, %g, %g), normal (%g, %g, %g), kd %g, %d light%s, the first at (%g, %g, %g): "
        "found (%.5g, %.5g, %.5g), expected (%.5g, %.5g, %.5g) (%d of %d inputs are wrong)%s",
        (double)job->point.x, (double)job->point.y, (double)job->point.z, (double)job->normal.x,
        (double)job->normal.y, (double)job->normal.z, (double)job->material.kd, job->n_lights,
        job->n_lights == 1 ? "" : "s", (double)light.position.x, (double)light.position.y,
        (double)light.position.z, (double)own.x, (double)own.y, (double)own.z, expected.x,
        expected.y, expected.z, wrong.n, N_SHADE_INPUTS, wrong.why));
}
