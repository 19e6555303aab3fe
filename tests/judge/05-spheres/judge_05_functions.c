// Lab 05: each function on its inputs. See judge_05.h.
//
// Every function has a list of known mistakes, as rules of the oracle.
#include "judge_05.h"

#include "message.h"
#include "oracle3d.h"
#include "words.h"

#include <math.h>

static const OracleRules3D right = {0};

// A known mistake, and what is said about it; number 0 is none.
typedef struct RuleMistake {
    Cause cause;
    OracleRules3D rules;
    int is_textbook;  // intersect_sphere in the textbook's form
} RuleMistake;

static const RuleMistake root_mistakes[] = {
    {.cause = {0}},
    {{.says = "that is the farther root, where the ray leaves the sphere"},
     .rules = {.farther_root = 1}},
    {{.says = "that is not beyond t_min"}, .rules = {.any_distance = 1}},
    {{.says = "from inside the second root is the hit: b + sqrt(disc)"},
     .rules = {.inside_is_miss = 1}},
    {{.says = "a negative radius means that only the farther root counts"},
     .rules = {.radius_sign_ignored = 1}},
    {{.says = "a sphere with a negative radius is seen from inside"},
     .rules = {.negative_radius_missed = 1}},
    {{.says = "the digits are lost: the textbook's form, or one like it, which squares before it "
              "subtracts"},
     .is_textbook = 1},
};

// ---- nearest_root -------------------------------------------------------------------------------

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

static int root_agrees(const void *pointer, int i, const void *answers, int mistake)
{
    const RootJob job = ((const Job05 *)pointer)->roots[i];
    const OracleRules3D *rules = &root_mistakes[mistake].rules;
    const float found = ((const float *)answers)[i];
    if (job.disc == 0) {
        // Exact in float, too: the one root is b, and a hit where it is beyond t_min.
        const int is_hit = job.b > job.t_min || rules->any_distance;
        return is_hit ? found == job.b : isinf(found) && found > 0;
    }
    const OracleRoot root = expected_root(job, rules);
    return is_right_root(&root, found);
}

static char *describe_root(const void *pointer, int i, const void *answers)
{
    const RootJob job = ((const Job05 *)pointer)->roots[i];
    const double expected = job.disc != 0       ? expected_root(job, &right).t
                            : job.b > job.t_min ? (double)job.b
                                                : (double)INFINITY;
    return message_new("b %g, disc %g, radius %g, t_min %g: found %.7g, expected %.7g", job.b,
                       job.disc, job.radius, job.t_min, ((const float *)answers)[i], expected);
}

const Function nearest_root_05 = {"roots",
                                  3 * N_ROOTS,
                                  sizeof(float),
                                  .describe = describe_root,
                                  .agrees = root_agrees,
                                  .counted = "inputs",
                                  MISTAKES(root_mistakes)};

// ---- intersect_textbook, intersect_sphere -------------------------------------------------------

static OracleRoot expected_hit(const SphereRayJob *job, OracleForm form, const OracleRules3D *rules)
{
    const OracleRay ray = oracle3d_given_ray(job->origin, job->direction, job->t_min);
    return oracle3d_root(job->sphere, &ray, form, rules);
}

static int textbook_agrees(const void *job, int i, const void *answers, int mistake)
{
    const OracleRoot root = expected_hit(&((const Job05 *)job)->textbook[i], ORACLE_TEXTBOOK,
                                         &root_mistakes[mistake].rules);
    return is_right_root(&root, ((const float *)answers)[i]);
}

static int projection_agrees(const void *job, int i, const void *answers, int number)
{
    const RuleMistake *mistake = &root_mistakes[number];
    const OracleRoot root =
        expected_hit(&((const Job05 *)job)->projection[i],
                     mistake->is_textbook ? ORACLE_TEXTBOOK : ORACLE_PROJECTION, &mistake->rules);
    return is_right_root(&root, ((const float *)answers)[i]);
}

static char *describe_sphere(const SphereRayJob *job, OracleForm form, float found)
{
    return message_new("sphere at %s, ray from %s along %s: found %.9g, expected %.9g",
                       words_sphere(job->sphere).text, words_vec3(job->origin, 6).text,
                       words_vec3(job->direction, 7).text, found,
                       expected_hit(job, form, &right).t);
}

static char *describe_textbook(const void *job, int i, const void *answers)
{
    return describe_sphere(&((const Job05 *)job)->textbook[i], ORACLE_TEXTBOOK,
                           ((const float *)answers)[i]);
}

static char *describe_projection(const void *job, int i, const void *answers)
{
    return describe_sphere(&((const Job05 *)job)->projection[i], ORACLE_PROJECTION,
                           ((const float *)answers)[i]);
}

const Function textbook_05 = {"textbook",
                              2 * N_SPHERES,
                              sizeof(float),
                              .describe = describe_textbook,
                              .agrees = textbook_agrees,
                              .counted = "inputs",
                              MISTAKES(root_mistakes)};
const Function projection_05 = {"projection",
                                3 * N_SPHERES,
                                sizeof(float),
                                .describe = describe_projection,
                                .agrees = projection_agrees,
                                .counted = "inputs",
                                MISTAKES(root_mistakes)};

// ---- surface_normal -----------------------------------------------------------------------------

static const RuleMistake normal_mistakes[] = {
    {.cause = {0}},
    {{.says = "it is not a unit vector"}, .rules = {.normal_not_normalised = 1}},
    {{.says = "it is not a unit vector, and points away from the eye"},
     .rules = {.normal_not_normalised = 1, .normal_not_turned = 1}},
    {{.says = "seen from inside it must be turned, towards the eye"},
     .rules = {.normal_not_turned = 1}},
    {{.says = "it points to the centre, not away from it"}, .rules = {.normal_always_turned = 1}},
    {{.says = "it points away from where the ray comes from"}, .rules = {.normal_turned_away = 1}},
};

static OracleNear expected_normal(const void *pointer, int i, const OracleRules3D *rules)
{
    const NormalJob *job = &((const Job05 *)pointer)->normals[i];
    return oracle3d_normal(job->sphere, oracle3d_exactly(job->point),
                           oracle3d_exactly(job->direction), rules);
}

static int normal_agrees(const void *job, int i, const void *answers, int mistake)
{
    return oracle3d_is_near(((const Vec3 *)answers)[i],
                            expected_normal(job, i, &normal_mistakes[mistake].rules));
}

static char *describe_normal(const void *pointer, int i, const void *answers)
{
    const NormalJob *job = &((const Job05 *)pointer)->normals[i];
    const OracleVector e = expected_normal(pointer, i, &right).value;
    return message_new("sphere at %s, point %s, direction %s: found %s, expected %s",
                       words_sphere(job->sphere).text, words_vec3(job->point, 6).text,
                       words_vec3(job->direction, 6).text,
                       words_vec3(((const Vec3 *)answers)[i], 5).text,
                       words_xyz(e.x, e.y, e.z, 5).text);
}

const Function normal_05 = {"normals",
                            2 * N_NORMALS,
                            sizeof(Vec3),
                            .describe = describe_normal,
                            .agrees = normal_agrees,
                            .counted = "inputs",
                            MISTAKES(normal_mistakes)};

// ---- shade --------------------------------------------------------------------------------------

static const RuleMistake shade_mistakes[] = {
    {.cause = {0}},
    {{.says = "a light behind the surface takes light away: a negative cosine counts as 0"},
     .rules = {.cosine_not_clamped = 1}},
    {{.says = "a light behind the surface lights it: a negative cosine counts as 0"},
     .rules = {.cosine_absolute = 1}},
    {{.says = "the way to the light is not made a unit vector"},
     .rules = {.to_light_not_normalised = 1}},
    {{.says = "that is the first light's share only"}, .rules = {.first_light_only = 1}},
    {{.says = "that is the last light's share only"}, .rules = {.last_light_only = 1}},
    {{.says = "one light too many shines, the one behind the end of the array"},
     .rules = {.one_light_more = 1}},
    {{.says = "kd is missing"}, .rules = {.ignore_kd = 1}},
    {{.says = "the material's colour is missing"}, .rules = {.ignore_color = 1}},
    {{.says = "the light's colour is missing"}, .rules = {.ignore_light_color = 1}},
    {{"that is right with red and blue swapped", MISTAKE_CHANNELS_SWAPPED},
     .rules = {.red_blue_swapped = 1}},
    {{"that is right but for gamma: the colour was raised to 1 / 2.2, but it is linear here",
      MISTAKE_GAMMA},
     .rules = {.gamma = 1 / 2.2}},
    {{"that is right but for gamma: the colour was raised to 2.2, but it is linear here",
      MISTAKE_GAMMA},
     .rules = {.gamma = 2.2}},
};

static OracleNear expected_shade(const void *pointer, int i, const OracleRules3D *rules)
{
    const Job05 *job = pointer;
    const ShadeJob *in = &job->shades[i];
    return oracle3d_shade(oracle3d_exactly(in->point), oracle3d_exactly(in->normal), &in->material,
                          job->lights + in->first_light, in->n_lights, rules);
}

static int shade_agrees(const void *job, int i, const void *answers, int mistake)
{
    return oracle3d_is_near(((const Vec3 *)answers)[i],
                            expected_shade(job, i, &shade_mistakes[mistake].rules));
}

static char *describe_shade(const void *pointer, int i, const void *answers)
{
    const Job05 *job = pointer;
    const ShadeJob *in = &job->shades[i];
    const OracleVector e = expected_shade(job, i, &right).value;
    return message_new(
        "point %s, normal %s, kd %g, %d light%s, the first at %s: found %s, expected "
        "%s",
        words_vec3(in->point, 6).text, words_vec3(in->normal, 6).text, in->material.kd,
        in->n_lights, plural((unsigned)in->n_lights),
        words_vec3(job->lights[in->first_light].position, 6).text,
        words_vec3(((const Vec3 *)answers)[i], 5).text, words_xyz(e.x, e.y, e.z, 5).text);
}

const Function shade_05 = {"shades",
                           3 * N_SHADES,
                           sizeof(Vec3),
                           .describe = describe_shade,
                           .agrees = shade_agrees,
                           .counted = "inputs",
                           MISTAKES(shade_mistakes)};
