// Lab 09: which lights arrive at a point, and how they add up. The points and lights are rolled in
// judge_09_lit.c.
#include "judge_09.h"

#include "message.h"
#include "oracle3d_rounding.h"
#include "words.h"

#include <math.h>

// The points and lights: alone they are those that stubs foresee.
static const LitJob *lit_of(const Job09 *job, int i)
{
    return job->job.is_alone ? &job->alone_lits[i] : &job->lits[i];
}

static const Light *lights_of(const Job09 *job, const LitJob *lit)
{
    return (job->job.is_alone ? job->alone_lights : job->lit_lights) + lit->first_light;
}

#define GIVEN                                                                                      \
    const LitJob *in = lit_of(job, i);                                                             \
    const LitAnswer *found = (const LitAnswer *)answers + i

// ---- Right --------------------------------------------------------------------------------------

static OracleNear arriving_alone(const Job09 *job, const LitJob *in);

static OracleNear right_light(const Job09 *job, int i)
{
    static const OracleMirrorRules right = {0};
    const LitJob *in = lit_of(job, i);
    if (job->job.is_alone) {
        return arriving_alone(job, in);
    }
    Scene3D scene = job->scenes[LIT_SCENE].base.scene;
    scene.lights = (Light *)(job->lit_lights + in->first_light);
    scene.n_lights = in->n_lights;
    return oracle3d_lit(&scene, oracle3d_exactly(in->point), oracle3d_exactly(in->normal),
                        &in->material, NULL, &right);
}

// How many of the lights may be before the surface: one ray for each is enough. The tree is that
// of a scene whose rays are counted, one leaf: the leaves visited are the rays sent.
static OracleSides light_sides(const Job09 *job, int i)
{
    const LitJob *in = lit_of(job, i);
    return oracle3d_sides(lights_of(job, in), in->n_lights, oracle3d_exactly(in->point),
                          oracle3d_exactly(in->normal));
}

static int is_light(int i, const LitAnswer *found, OracleNear expected)
{
    return lit_09_counts_only(i) || oracle3d_is_near(found->color, expected);
}

// No more rays than needed, which is judged in the second range. There some are sent where one is
// certainly needed, as no light here is black. Where none is, lights that arrive are found in
// another way, or `work` was not passed on.
static int sends_right(const Job09 *job, int i, u32 n_rays)
{
    const OracleSides sides = light_sides(job, i);
    return i / N_LIT_INPUTS != 1 ||
           (n_rays <= sides.n_before && (n_rays > 0 || sides.n_before == sides.n_unsure));
}

RIGHT(is_right, is_light(i, found, right_light(job, i)) && sends_right(job, i, found->n_leaves))

// ---- Mistakes of the rays alone -----------------------------------------------------------------

#define SENDS(name, condition, ...)                                                                \
    EACH(name, is_light(i, found, right_light(job, i)) && (condition), __VA_ARGS__)

// Of some input more rays are sent than it has lights: then one light is asked twice.
static int is_any_asked_twice(const Job09 *job, const LitAnswer *answers)
{
    int i = N_LIT_INPUTS;
    while (i < 2 * N_LIT_INPUTS && answers[i].n_leaves <= (u32)lit_of(job, i)->n_lights) {
        i++;
    }
    return i < 2 * N_LIT_INPUTS;
}

// Nothing comes of a light behind, and a ray is sent to it all the same.
static int is_side_inverted(const Job09 *job, int i, const LitAnswer *found)
{
    const LitJob *in = lit_of(job, i);
    const OracleSides sides = light_sides(job, i);
    const int is_black = found->color.x == 0 && found->color.y == 0 && found->color.z == 0;
    const u32 n_behind = (u32)in->n_lights - sides.n_before + sides.n_unsure;
    return lit_09_counts_only(i) ||
           (is_black && (i / N_LIT_INPUTS != 1 || found->n_leaves <= n_behind));
}

// ---- Mistakes of the sum ------------------------------------------------------------------------

// A light as a point sees it.
typedef struct SeenLight {
    OracleNear share;    // what it gives where it arrives; nothing from behind the surface
    double cosine;       // at which it comes
    double distance;     // scene units
    double brightest;    // channel of it
    double by_position;  // its position's part along the normal, as if that were the way to it
    double by_point;     // the same of the point
    int is_before;       // the surface
    int is_free;         // nothing stands between
    int is_free_beyond;  // nor behind the light
} SeenLight;

// A point's lights, and the one behind the end of the array.
typedef struct SeenLights {
    SeenLight each[MOST_LIT_LIGHTS + 1];
    int n;
    int is_unsure;  // rounding decides whether one of them arrives
} SeenLights;

static SeenLight see(const Job09 *job, const LitJob *lit, const Light *light, int *is_unsure)
{
    const Scene3D *scene = &job->scenes[LIT_SCENE].base.scene;
    static const OracleRules3D right = {0};
    static const OracleMirrorRules to_light = {0}, endless = {.endless_light = 1};
    const OracleNear point = oracle3d_exactly(lit->point), normal = oracle3d_exactly(lit->normal);
    const OracleVector position = vector_of(light->position);
    const OracleVector way = vector_minus(position, point.value);
    SeenLight seen = {.share = oracle3d_shade(point, normal, &lit->material, light, 1, &right),
                      .distance = vector_length(way),
                      .brightest = fmax(fmax(light->color.x, light->color.y), light->color.z),
                      .by_position = vector_dot(normal.value, position),
                      .by_point = vector_dot(normal.value, point.value)};
    seen.cosine = vector_dot(normal.value, way) / seen.distance;
    seen.is_before = seen.cosine > 0;
    if (job->job.is_alone) {
        seen.is_free = seen.is_free_beyond = !is_blocked_alone_09(
            lit->point, vec3_minus(light->position, lit->point), job->job.nonce);
    } else if (seen.is_before) {
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
        lights->each[i] = see(job, lit, lights_of(job, lit) + i, &lights->is_unsure);
    }
}

static int arrives(const SeenLight *light)
{
    return light->is_before && light->is_free;
}

static int is_blocked(const SeenLight *light)
{
    return light->is_before && !light->is_free;
}

static int is_behind(const SeenLight *light)
{
    return !light->is_before;
}

static int is_dark(const SeenLight *light)
{
    return !arrives(light);
}

// The first light of a kind, or n.
static int first_of(const SeenLights *all, int (*is_kind)(const SeenLight *light))
{
    int k = 0;
    while (k < all->n && !is_kind(&all->each[k])) {
        k++;
    }
    return k;
}

static int n_arriving(const SeenLights *all, int end)
{
    int n = 0;
    for (int k = 0; k < end; k++) {
        n += arrives(&all->each[k]);
    }
    return n;
}

// Add a light's share, as often as a mistake counts it.
static void add_share(OracleNear *sum, const SeenLight *light, double factor)
{
    sum->value = vector_plus(sum->value, vector_scaled(factor, light->share.value));
    sum->error += fabs(factor) * light->share.error;
}

// The sum as far as it is known. Each sum rounds, twice where it is one of sums.
static OracleNear summed(const SeenLights *all, OracleNear sum)
{
    sum.error += 4 * ROUNDING * all->n * vector_length(sum.value);
    return all->is_unsure ? (OracleNear){{0}, INFINITY} : sum;
}

static OracleNear right_sum(const SeenLights *all)
{
    OracleNear sum = {{0}, 0};
    for (int k = 0; k < all->n; k++) {
        add_share(&sum, &all->each[k], arrives(&all->each[k]));
    }
    return summed(all, sum);
}

static OracleNear arriving_alone(const Job09 *job, const LitJob *in)
{
    SeenLights all;
    see_all(job, in, &all);
    return right_sum(&all);
}

// By its colours a mistake of the sum is known, whether rays are sent or not; but where only the
// rays are wrong, it is no cause.
static int is_sum(const Job09 *job, int i, const LitAnswer *found, OracleNear expected)
{
    return is_light(i, found, expected) &&
           (sends_right(job, i, found->n_leaves) || !is_light(i, found, right_light(job, i)));
}

// How often light number k counts: of all n of them, and of the one behind their end.
#define SUMS_OF(name, n_ways, factor, ...)                                                         \
    for (int k = 0; number == 0 && k <= all.n; k++) {                                              \
        const SeenLight *light = &all.each[k];                                                     \
        const int is_one = k < all.n, counts = is_one && arrives(light);                           \
        (void)is_one, (void)counts;                                                                \
        add_share(&sum, light, factor);                                                            \
    }                                                                                              \
    ONE_OF(name, n_ways, is_sum(job, i, found, summed(&all, sum)), __VA_ARGS__)
#define SUMS(name, factor, ...) SUMS_OF(name, 1, factor, __VA_ARGS__)

static OracleNear with_color_twice(const LitJob *in, OracleNear sum)
{
    const Vec3 c = in->material.color;
    sum.value = (OracleVector){sum.value.x * c.x, sum.value.y * c.y, sum.value.z * c.z};
    return sum;
}

static OracleNear cut_at_one(OracleNear sum)
{
    sum.value = (OracleVector){fmin(sum.value.x, 1), fmin(sum.value.y, 1), fmin(sum.value.z, 1)};
    return sum;
}

KNOWN_LIST(known)
{
    GIVEN;
    const u32 n_rays = found->n_leaves, n_needed = light_sides(job, i).n_before;
    SeenLights all;
    OracleNear sum = {{0}, 0};
    see_all(job, in, &all);

    SENDS(asks_all, n_rays == (u32)in->n_lights,
          "a ray was sent to every light: on which side of the surface it is, is asked first");
    SENDS(asks_twice,
          n_rays >= n_needed && (n_rays == 0 || n_needed > 0) && is_any_asked_twice(job, answers),
          "a light is asked more than once: one ray says whether it arrives");
    SENDS(uncounted, n_rays == 0,
          "no ray is counted: is_blocked is not asked, or `work` was not passed on to it");

    EACH(side_inverted, is_side_inverted(job, i, found),
         "lights before the surface are left out, and those behind it are asked: the sign of the "
         "cosine");

    // By which lights are asked.
    SUMS(first_only, k == 0 && counts, "that is the first light's share only");
    SUMS(last_only, k == all.n - 1 && counts, "that is the last light's share only");
    SUMS(without_first, k > 0 && counts, "the first light is not asked");
    SUMS(without_last, k < all.n - 1 && counts, "the last light is not asked");
    SUMS(one_more, arrives(light),
         "one light too many shines, the one behind the end of the array");
    SUMS(blocked_ends, k < first_of(&all, is_blocked) && counts,
         "after a light that is blocked no other one is asked");
    SUMS(behind_ends, k < first_of(&all, is_behind) && counts,
         "a light behind the surface ended the loop: the next one may be before it");
    SUMS(dark_ends, k < first_of(&all, is_dark) && counts,
         "a light that does not arrive ended the loop: the next one may arrive");
    SUMS(first_arriving, k == first_of(&all, arrives) && counts,
         "the first light that arrives ended the loop: the next one may arrive, too");

    SUMS_OF(only_some, 7, k < (4 << way) && counts,
            "where lights are many, not all of them are asked: n_lights says how many they are");

    // By which of them arrive.
    SUMS(without_shadows, is_one, "light is added although something stands between");
    SUMS(only_blocked, is_blocked(light) && is_one,
         "light is added where something stands between, and not where nothing does");
    SUMS(blocked_beyond, is_one && light->is_free_beyond,
         "what stands behind the light casts a shadow, too");
    SUMS(all_or_none, first_of(&all, is_blocked) == all.n && counts,
         "one light that does not arrive takes the others with it");
    SUMS(all_by_first_ray, arrives(&all.each[0]) && is_one,
         "the first light's ray was asked for all of them: each needs one of its own");
    SUMS(side_by_position, is_one && light->is_free && light->by_position > 0,
         "before the surface or behind it is asked with the light's position: the way to it begins "
         "at the point");
    SUMS(side_by_point, counts && light->by_point > 0,
         "before the surface or behind it is asked with the point: it takes the direction to the "
         "light");
    SUMS(taken_off, -counts, "the lights' shares are taken off: they are added");
    SUMS(dark_left_out, counts && light->brightest >= 0x1p-10,
         "a dark light is left out: where much of it is scattered, it shows");
    SUMS(little_kd_lost, counts && in->material.kd >= 0x1p-10f,
         "a surface that scatters little is not lit: where a light is bright, it shows");

    static const double grazing[] = {0.05, 0x1p-9, 0x1p-15};
    SUMS_OF(grazing_lost, 3, counts && light->cosine >= grazing[way],
            "light that grazes the surface arrives, too: a cosine above 0 is enough, without an "
            "epsilon");

    // By how they are added.
    SUMS(mean, counts / fmax(all.n, 1),
         "the lights' shares add up: they are not divided by how many there are");
    SUMS(falling, counts / (light->distance * light->distance),
         "light does not fall with the distance here: shade knows all that counts");
    SUMS(cosine_twice, counts * light->cosine, "shade has the cosine already: it counts once");
    SUMS(kd_twice, counts ? (double)in->material.kd : 0, "shade has kd already: it counts once");
    SUMS(adds_all, is_one ? n_arriving(&all, all.n) : 0,
         "every light was added once for each light");
    SUMS(adds_rest, is_one ? n_arriving(&all, k + 1) : 0,
         "with each light that arrives those behind it in the array were added again");
    SUMS(share_of_first, k == 0 ? n_arriving(&all, all.n) : 0,
         "each light that arrives added the first one's share, not its own");
    SUMS(last_arriving, n_arriving(&all, k + 1) == n_arriving(&all, all.n) && counts,
         "the shares add up: each light that arrives took the place of the one before it");

    EACH(color_twice, is_sum(job, i, found, with_color_twice(in, right_sum(&all))),
         "shade has the material's colour already: it counts once");
    EACH(cut, is_sum(job, i, found, cut_at_one(right_sum(&all))),
         "the sum is cut at 1: light may be brighter than that");
    return NO_MORE;
}

// ---- Answers ------------------------------------------------------------------------------------

static char *describe(const void *pointer, int i, const void *answers)
{
    const Job09 *job = pointer;
    const LitJob *in = lit_of(job, i);
    const LitAnswer *found = (const LitAnswer *)answers + i;
    const OracleVector e = right_light(job, i).value;
    const u32 n_needed = light_sides(job, i).n_before;
    if (!sends_right(job, i, found->n_leaves)) {
        return message_new("point %s, normal %s, %d light%s, %s before the surface: found %u ray%s "
                           "sent to lights, expected %s: one for each light before the surface, "
                           "and none for a light behind",
                           words_vec3(in->point, 6).text, words_vec3(in->normal, 6).text,
                           in->n_lights, plural((unsigned)in->n_lights),
                           n_needed == 0 ? "none" : words("%u", n_needed).text, found->n_leaves,
                           plural(found->n_leaves),
                           n_needed == 0          ? "none"
                           : found->n_leaves == 0 ? words("%u", n_needed).text
                                                  : words("at most %u", n_needed).text);
    }
    return message_new("point %s, normal %s, %d light%s, the first at %s: found %s, expected %s",
                       words_vec3(in->point, 6).text, words_vec3(in->normal, 6).text, in->n_lights,
                       plural((unsigned)in->n_lights),
                       words_vec3(lights_of(job, in)->position, 6).text,
                       words_vec3(found->color, 5).text, words_xyz(e.x, e.y, e.z, 5).text);
}

const Function lit_09 = {"lits", N_LITS, sizeof(LitAnswer), KNOWING(is_right, describe, known),
                         .is_known_by_range = 1};
