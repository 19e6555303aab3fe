// Known mistakes of lit_color (see judge_09_lights.h).
#include "judge_09_lights.h"

#include "oracle3d_rounding.h"

// A light as a point sees it.
typedef struct SeenLight {
    OracleNear share;    // what it gives where it arrives; nothing from behind the surface
    double cosine;       // at which it comes
    double distance;     // scene units
    double brightest;    // channel of it
    double by_position;  // its position's part along the normal, as if that were the way to it
    int is_before;       // the surface
    int is_free;         // nothing stands between
    int is_free_beyond;  // nor behind the light
} SeenLight;

// A point's lights, and the one behind the end of the array.
struct SeenLights {
    SeenLight each[MOST_LIT_LIGHTS + 1];
    int n;
    int is_unsure;  // rounding decides whether one of them arrives
};

static int least(int a, int b)
{
    return a < b ? a : b;
}

// ---- Seeing lights ------------------------------------------------------------------------------

static SeenLight see(const Scene3D *scene, const LitJob *lit, const Light *light, int *is_unsure)
{
    static const OracleRules3D right = {0};
    static const OracleMirrorRules to_light = {0}, endless = {.endless_light = 1};
    const OracleNear point = oracle3d_exactly(lit->point), normal = oracle3d_exactly(lit->normal);
    const OracleVector position = vector_of(light->position);
    const OracleVector way = vector_minus(position, point.value);
    SeenLight seen = {.share = oracle3d_shade(point, normal, &lit->material, light, 1, &right),
                      .distance = vector_length(way),
                      .brightest = fmax(fmax(light->color.x, light->color.y), light->color.z),
                      .by_position = vector_dot(normal.value, position)};
    seen.cosine = vector_dot(normal.value, way) / seen.distance;
    seen.is_before = seen.cosine > 0;
    if (seen.is_before) {
        const OracleArrival arrival = oracle3d_arrival(scene, point, light, NULL, &to_light);
        seen.is_free = arrival == LIGHT_ARRIVES;
        seen.is_free_beyond =
            oracle3d_arrival(scene, point, light, NULL, &endless) == LIGHT_ARRIVES;
        *is_unsure |= arrival == LIGHT_IS_UNSURE;
    }
    return seen;
}

static void see_all(const Job09 *job, const LitJob *lit, SeenLights *lights)
{
    lights->n = lit->n_lights;
    lights->is_unsure = 0;
    for (int i = 0; i <= lights->n; i++) {
        lights->each[i] = see(&job->scenes[LIT_SCENE].base.scene, lit,
                              &job->lit_lights[lit->first_light + i], &lights->is_unsure);
    }
}

OracleNear lights_09_mistaken(const Job09 *job, const LitJob *lit, const LitMistake *mistake)
{
    SeenLights lights;
    see_all(job, lit, &lights);
    lights.n = mistake->most_lights > 0 ? least(mistake->most_lights, lights.n) : lights.n;
    for (int i = 0; i <= lights.n; i++) {
        SeenLight *light = &lights.each[i];
        light->is_free &= light->cosine >= mistake->least_cosine &&
                          light->brightest >= mistake->least_light &&
                          lit->material.kd >= mistake->least_kd;
    }
    OracleNear sum = mistake->sum(&lights);
    const Vec3 c = mistake->color_again ? lit->material.color : (Vec3){1, 1, 1};
    const double kd = mistake->kd_again ? (double)lit->material.kd : 1;
    sum.value =
        (OracleVector){kd * sum.value.x * c.x, kd * sum.value.y * c.y, kd * sum.value.z * c.z};
    // Each sum rounds, twice where it is one of sums.
    sum.error += 4 * ROUNDING * lights.n * vector_length(sum.value);
    return lights.is_unsure ? (OracleNear){{0}, INFINITY} : sum;
}

// ---- Sums ---------------------------------------------------------------------------------------

static int arrives(const SeenLight *light)
{
    return light->is_before && light->is_free;
}

static int is_blocked(const SeenLight *light)
{
    return light->is_before && !light->is_free;
}

static void add(OracleNear *sum, double factor, OracleNear share)
{
    sum->value = vector_plus(sum->value, vector_scaled(factor, share.value));
    sum->error += fabs(factor) * share.error;
}

// What the lights from `first` on give before `end`, whatever stands between.
static OracleNear shares_of(const SeenLights *lights, int first, int end)
{
    OracleNear sum = {{0}, 0};
    for (int i = first; i < end; i++) {
        add(&sum, 1, lights->each[i].share);
    }
    return sum;
}

// What those of them give that arrive.
static OracleNear arriving(const SeenLights *lights, int first, int end)
{
    OracleNear sum = {{0}, 0};
    for (int i = first; i < end; i++) {
        add(&sum, arrives(&lights->each[i]), lights->each[i].share);
    }
    return sum;
}

static OracleNear all_arriving(const SeenLights *lights)
{
    return arriving(lights, 0, lights->n);
}

// ---- Which lights are asked ---------------------------------------------------------------------

static OracleNear first_only(const SeenLights *lights)
{
    return arriving(lights, 0, least(1, lights->n));
}

static OracleNear last_only(const SeenLights *lights)
{
    return arriving(lights, lights->n > 0 ? lights->n - 1 : 0, lights->n);
}

static OracleNear without_first(const SeenLights *lights)
{
    return arriving(lights, 1, lights->n);
}

static OracleNear without_last(const SeenLights *lights)
{
    return arriving(lights, 0, lights->n - 1);
}

static OracleNear one_more(const SeenLights *lights)
{
    return arriving(lights, 0, lights->n + 1);
}

static OracleNear ended_by_blocked(const SeenLights *lights)
{
    int end = 0;
    while (end < lights->n && !is_blocked(&lights->each[end])) {
        end++;
    }
    return arriving(lights, 0, end);
}

static OracleNear ended_by_behind(const SeenLights *lights)
{
    int end = 0;
    while (end < lights->n && lights->each[end].is_before) {
        end++;
    }
    return arriving(lights, 0, end);
}

static OracleNear ended_by_either(const SeenLights *lights)
{
    int end = 0;
    while (end < lights->n && arrives(&lights->each[end])) {
        end++;
    }
    return arriving(lights, 0, end);
}

static OracleNear ended_by_arriving(const SeenLights *lights)
{
    int end = 0;
    while (end < lights->n && !arrives(&lights->each[end])) {
        end++;
    }
    return arriving(lights, end, least(end + 1, lights->n));
}

// ---- Which of them arrive -----------------------------------------------------------------------

static OracleNear without_shadows(const SeenLights *lights)
{
    return shares_of(lights, 0, lights->n);
}

static OracleNear only_blocked(const SeenLights *lights)
{
    OracleNear sum = {{0}, 0};
    for (int i = 0; i < lights->n; i++) {
        add(&sum, is_blocked(&lights->each[i]), lights->each[i].share);
    }
    return sum;
}

static OracleNear blocked_from_behind(const SeenLights *lights)
{
    OracleNear sum = {{0}, 0};
    for (int i = 0; i < lights->n; i++) {
        add(&sum, lights->each[i].is_free_beyond, lights->each[i].share);
    }
    return sum;
}

static OracleNear all_or_none(const SeenLights *lights)
{
    int n_blocked = 0;
    for (int i = 0; i < lights->n; i++) {
        n_blocked += is_blocked(&lights->each[i]);
    }
    return arriving(lights, 0, n_blocked == 0 ? lights->n : 0);
}

static OracleNear all_by_first_ray(const SeenLights *lights)
{
    return shares_of(lights, 0, arrives(&lights->each[0]) ? lights->n : 0);
}

static OracleNear side_by_position(const SeenLights *lights)
{
    OracleNear sum = {{0}, 0};
    for (int i = 0; i < lights->n; i++) {
        const SeenLight *light = &lights->each[i];
        add(&sum, light->is_free && light->by_position > 0, light->share);
    }
    return sum;
}

// ---- How they are added -------------------------------------------------------------------------

static OracleNear mean(const SeenLights *lights)
{
    OracleNear sum = {{0}, 0};
    add(&sum, lights->n > 0 ? 1.0 / lights->n : 1, all_arriving(lights));
    return sum;
}

static OracleNear falling(const SeenLights *lights)
{
    OracleNear sum = {{0}, 0};
    for (int i = 0; i < lights->n; i++) {
        const SeenLight *light = &lights->each[i];
        add(&sum, arrives(light) / (light->distance * light->distance), light->share);
    }
    return sum;
}

static OracleNear cosine_twice(const SeenLights *lights)
{
    OracleNear sum = {{0}, 0};
    for (int i = 0; i < lights->n; i++) {
        const SeenLight *light = &lights->each[i];
        add(&sum, arrives(light) * light->cosine, light->share);
    }
    return sum;
}

// For each light that arrives all of them, or all from its own place on.
static OracleNear all_for_each(const SeenLights *lights, int is_from_own)
{
    OracleNear sum = {{0}, 0};
    for (int i = 0; i < lights->n; i++) {
        add(&sum, arrives(&lights->each[i]), shares_of(lights, is_from_own ? i : 0, lights->n));
    }
    return sum;
}

static OracleNear each_adds_all(const SeenLights *lights)
{
    return all_for_each(lights, 0);
}

static OracleNear each_adds_rest(const SeenLights *lights)
{
    return all_for_each(lights, 1);
}

static OracleNear share_of_first(const SeenLights *lights)
{
    OracleNear sum = {{0}, 0};
    for (int i = 0; i < lights->n; i++) {
        add(&sum, arrives(&lights->each[i]), lights->each[0].share);
    }
    return sum;
}

static OracleNear last_arriving(const SeenLights *lights)
{
    int last = lights->n - 1;
    while (last >= 0 && !arrives(&lights->each[last])) {
        last--;
    }
    return last < 0 ? (OracleNear){{0}, 0} : lights->each[last].share;
}

static OracleNear cut_at_one(const SeenLights *lights)
{
    OracleNear sum = all_arriving(lights);
    sum.value = (OracleVector){fmin(sum.value.x, 1), fmin(sum.value.y, 1), fmin(sum.value.z, 1)};
    return sum;
}

// ---- All of them --------------------------------------------------------------------------------

#define GRAZING_LOST                                                                               \
    {.says = "light that grazes the surface arrives, too: a cosine above 0 is enough, without "    \
             "an epsilon"}
#define NOT_ALL_ASKED                                                                              \
    {.says = "where lights are many, not all of them are asked: n_lights says how many they "      \
             "are"}

const LitMistake lit_mistakes_09[N_LIT_MISTAKES] = {
    {.cause = {0}},
    [LIT_ASKS_ALL] = {.cause = {.says = "a ray was sent to every light: on which side of the "
                                        "surface it is, is asked first"}},
    [LIT_ASKS_TWICE] = {.cause = {.says =
                                      "a light is asked more than once: one ray says whether it "
                                      "arrives"}},
    [LIT_UNCOUNTED] = {.cause = {.says = "no ray is counted: is_blocked is not asked, or `work` "
                                         "was not passed on to it"}},
    {{.says = "light is added although something stands between"}, .sum = without_shadows},
    {{.says = "light is added where something stands between, and not where nothing does"},
     .sum = only_blocked},
    {{.says = "what stands behind the light casts a shadow, too"}, .sum = blocked_from_behind},
    {{.says = "that is the first light's share only"}, .sum = first_only},
    {{.says = "that is the last light's share only"}, .sum = last_only},
    {{.says = "the first light is not asked"}, .sum = without_first},
    {{.says = "the last light is not asked"}, .sum = without_last},
    {{.says = "one light too many shines, the one behind the end of the array"}, .sum = one_more},
    {NOT_ALL_ASKED, .sum = all_arriving, .most_lights = 4},
    {NOT_ALL_ASKED, .sum = all_arriving, .most_lights = 8},
    {NOT_ALL_ASKED, .sum = all_arriving, .most_lights = 16},
    {NOT_ALL_ASKED, .sum = all_arriving, .most_lights = 32},
    {NOT_ALL_ASKED, .sum = all_arriving, .most_lights = 64},
    {NOT_ALL_ASKED, .sum = all_arriving, .most_lights = 128},
    {NOT_ALL_ASKED, .sum = all_arriving, .most_lights = 256},
    {{.says = "after a light that is blocked no other one is asked"}, .sum = ended_by_blocked},
    {{.says = "a light behind the surface ended the loop: the next one may be before it"},
     .sum = ended_by_behind},
    {{.says = "a light that does not arrive ended the loop: the next one may arrive"},
     .sum = ended_by_either},
    {{.says = "the first light that arrives ended the loop: the next one may arrive, too"},
     .sum = ended_by_arriving},
    {{.says = "one light that does not arrive takes the others with it"}, .sum = all_or_none},
    {{.says = "the first light's ray was asked for all of them: each needs one of its own"},
     .sum = all_by_first_ray},
    {GRAZING_LOST, .sum = all_arriving, .least_cosine = 0.05},
    {GRAZING_LOST, .sum = all_arriving, .least_cosine = 0x1p-9},
    {GRAZING_LOST, .sum = all_arriving, .least_cosine = 0x1p-15},
    {{.says = "a dark light is left out: where much of it is scattered, it shows"},
     .sum = all_arriving,
     .least_light = 0x1p-10},
    {{.says = "a surface that scatters little is not lit: where a light is bright, it shows"},
     .sum = all_arriving,
     .least_kd = 0x1p-10},
    {{.says = "before the surface or behind it is asked with the light's position: the way to it "
              "begins at the point"},
     .sum = side_by_position},
    {{.says = "the lights' shares add up: they are not divided by how many there are"},
     .sum = mean},
    {{.says = "light does not fall with the distance here: shade knows all that counts"},
     .sum = falling},
    {{.says = "shade has the cosine already: it counts once"}, .sum = cosine_twice},
    {{.says = "shade has kd already: it counts once"}, .sum = all_arriving, .kd_again = 1},
    {{.says = "shade has the material's colour already: it counts once"},
     .sum = all_arriving,
     .color_again = 1},
    {{.says = "every light was added once for each light"}, .sum = each_adds_all},
    {{.says = "with each light that arrives those behind it in the array were added again"},
     .sum = each_adds_rest},
    {{.says = "each light that arrives added the first one's share, not its own"},
     .sum = share_of_first},
    {{.says = "the shares add up: each light that arrives took the place of the one before it"},
     .sum = last_arriving},
    {{.says = "the sum is cut at 1: light may be brighter than that"}, .sum = cut_at_one},
};
