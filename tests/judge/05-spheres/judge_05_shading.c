// Lab 05: surface_normal and shade on their inputs. See judge_05.h; judge_05_roots.c is a sibling.
#include "judge_05.h"

#include "message.h"
#include "oracle3d.h"
#include "words.h"

static const OracleRules3D right = {0};

// A known mistake, and what is said about it; number 0 is none.
typedef struct RuleMistake {
    Cause cause;
    OracleRules3D rules;
    int is_partly;  // other answers are right
    int vanishes;   // the normal of a tangent; other answers are right
} RuleMistake;

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
    {{.says = "it must be turned where the dot product is positive, however small"},
     .rules = {.normal_threshold = 0x1p-5}},
    {{.says = "it must not be turned where the dot product is negative, however small"},
     .rules = {.normal_threshold = -0x1p-5}},
    {{.says = "it must be turned where the dot product is positive, however small"},
     .rules = {.normal_threshold = 0x1p-30}},
    {{.says = "it must not be turned where the dot product is negative, however small"},
     .rules = {.normal_threshold = -0x1p-30}},
    {{.says = "the radius' sign turned it: the dot product with the direction decides"},
     .rules = {.normal_turned_by_radius = 1}},
    {{.says = "the point's place in the scene turned it: the normal's dot product decides"},
     .rules = {.normal_turned_by_place = 1}},
    {{.says = "it was divided by the radius: where float rounds the point, that is not how far the "
              "centre is, and the normal is no unit vector"},
     .rules = {.normal_by_radius = 1}},
    {{.says = "other normals are right, but a short vector must be made a unit vector, too"},
     .rules = {.normal_not_normalised = 1},
     .is_partly = 1},
    {{.says = "other normals are right, but where the ray is a tangent the dot product is 0, and "
              "the normal was multiplied by it"},
     .vanishes = 1},
};

static OracleNear expected_normal(const void *pointer, int i, const OracleRules3D *rules)
{
    const NormalJob *job = &((const Job05 *)pointer)->normals[i];
    return oracle3d_normal(job->sphere, oracle3d_exactly(job->point),
                           oracle3d_exactly(job->direction), rules);
}

// Is the dot product 0, to the bit? Then the ray comes from neither side, and either is right.
static int is_tangent(const NormalJob *job)
{
    const OracleVector centre = {job->sphere.x, job->sphere.y, job->sphere.z};
    return vector_dot(vector_minus(vector_of(job->point), centre), vector_of(job->direction)) == 0;
}

static int normal_agrees(const void *pointer, int i, const void *answers, int mistake)
{
    const NormalJob *job = &((const Job05 *)pointer)->normals[i];
    const Vec3 found = ((const Vec3 *)answers)[i];
    const RuleMistake *known = &normal_mistakes[mistake];
    if (known->vanishes && is_tangent(job)) {
        return vec3_length(found) == 0;
    }
    const OracleNear expected = expected_normal(pointer, i, &known->rules);
    if (is_tangent(job) && oracle3d_is_near(vec3_scaled(found, -1), expected)) {
        return 1;
    }
    return oracle3d_is_near(found, expected) ||
           (known->is_partly && oracle3d_is_near(found, expected_normal(pointer, i, &right)));
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

const Function normal_05 = {"normals", 2 * N_NORMALS, sizeof(Vec3),
                            COMPARED(normal_agrees, describe_normal, normal_mistakes)};

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
    {{.says = "that is the first 4 lights' share only"}, .rules = {.most_lights = 4}},
    {{.says = "that is the first 8 lights' share only"}, .rules = {.most_lights = 8}},
    {{.says = "that is the first 16 lights' share only"}, .rules = {.most_lights = 16}},
    {{.says = "that is the first 32 lights' share only"}, .rules = {.most_lights = 32}},
    {{.says = "that is the first 64 lights' share only"}, .rules = {.most_lights = 64}},
    {{.says = "that is the first 128 lights' share only"}, .rules = {.most_lights = 128}},
    {{.says = "that is the first 256 lights' share only"}, .rules = {.most_lights = 256}},
    {{.says = "the sum was cut at 1, but many lights may be brighter"}, .rules = {.cut_at_one = 1}},
    {{.says = "each light was cut at 1, but a light may be brighter"},
     .rules = {.light_cut_at_one = 1}},
    {{.says = "the first light behind the surface ended the loop: those after it shine, too"},
     .rules = {.stops_behind = 1}},
    {{.says = "a light behind the surface takes light away: each negative cosine counts as 0, not "
              "only a negative sum"},
     .rules = {.sum_clamped = 1}},
    {{.says = "that is the brightest light's share only: the colour is the sum"},
     .rules = {.brightest_light = 1}},
    {{.says = "the sum was divided by the number of lights"}, .rules = {.mean_of_lights = 1}},
    {{.says = "the sum so far is multiplied by kd with each light"}, .rules = {.kd_each_round = 1}},
    {{.says = "the light's place was taken for the way to it: that begins at the point"},
     .rules = {.light_from_origin = 1}},
    {{.says = "the light falls with the square of the distance, and must not"},
     .rules = {.light_falls = 1}},
    {{.says = "the light's red was taken for its whole colour"}, .rules = {.light_red_only = 1}},
    {{.says = "a highlight was added, with ks: Lambert's law has none"}, .rules = {.highlight = 1}},
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
    if (shade_mistakes[mistake].rules.mean_of_lights &&
        ((const Job05 *)job)->shades[i].n_lights == 0) {
        return 1;  // 0 / 0, or kept from it
    }
    return oracle3d_is_near(((const Vec3 *)answers)[i],
                            expected_shade(job, i, &shade_mistakes[mistake].rules));
}

static char *describe_shade(const void *pointer, int i, const void *answers)
{
    const Job05 *job = pointer;
    const ShadeJob *in = &job->shades[i];
    const OracleVector e = expected_shade(job, i, &right).value;
    const Vec3 first = job->lights[in->first_light].position;
    return message_new(
        "point %s, normal %s, kd %g, %d light%s%s%s: found %s, expected %s",
        words_vec3(in->point, 6).text, words_vec3(in->normal, 6).text, in->material.kd,
        in->n_lights, plural((unsigned)in->n_lights), in->n_lights > 0 ? ", the first at " : "",
        in->n_lights > 0 ? words_vec3(first, 6).text : "",
        words_vec3(((const Vec3 *)answers)[i], 5).text, words_xyz(e.x, e.y, e.z, 5).text);
}

const Function shade_05 = {"shades", 3 * N_SHADES, sizeof(Vec3),
                           COMPARED(shade_agrees, describe_shade, shade_mistakes)};
