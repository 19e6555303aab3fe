// What is expected of a job's 3D scenes: hits and pictures by the oracle, and what wrong ones look
// like.
#include "job_scene3d.h"

#include "complain.h"
#include "job_sections.h"
#include "message.h"
#include "words.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

// A mistake made by the oracle.
typedef struct Mistake3D {
    Cause looks;
    OracleRules3D rules;
} Mistake3D;

static const Mistake3D mistakes[] = {
    // Of rays,
    {{"shifted by half a pixel: the ray goes through the pixel's corner, not its middle",
      MISTAKE_SHIFTED_HALF},
     {.sample_offset = -0.5}},
    {{"shifted by half a pixel: the ray goes through the pixel's far corner, not its middle",
      MISTAKE_SHIFTED_HALF},
     {.sample_offset = 0.5}},
    {{.says = "drawn as if fov were the display's height: it is its width"}, {.fov_is_height = 1}},
    {{.says = "drawn as if fov were the display's height as well: pixels are squares"},
     {.fov_both_ways = 1}},
    {{.says = "drawn as if fov were an angle: it is a width at distance 1"}, {.fov_is_angle = 1}},
    {{.says = "drawn as if fov were half the display's width"}, {.fov_is_half_width = 1}},
    {{.says = "drawn with directions that are not unit vectors"}, {.not_normalised = 1}},
    {{.says = "drawn with the view transform turned round (rows for columns)"},
     {.axes_transposed = 1}},
    // of hits,
    {{.says = "drawn as if the farther root were the hit: one sees the spheres' far sides"},
     {.farther_root = 1}},
    {{.says = "drawn as if t_min did not matter: hits behind the eye count"}, {.any_distance = 1}},
    {{.says = "drawn as if a sphere around the eye were not there: the second root is forgotten"},
     {.inside_is_miss = 1}},
    {{.says = "drawn as if the sign of the radius did not matter: negative means seen from inside "
              "only"},
     {.radius_sign_ignored = 1}},
    {{.says = "drawn as if spheres with a negative radius were not there"},
     {.negative_radius_missed = 1}},
    {{.says = "drawn as if the first sphere that is hit kept the pixel, however far"},
     {.first_wins = 1}},
    {{.says = "drawn as if distance did not matter: the last sphere that is hit covers the others"},
     {.last_wins = 1}},
    {{.says = "drawn as if the farthest sphere won: the comparison is inverted"},
     {.farthest_wins = 1}},
    {{"drawn as if of two equally far spheres the later one won", MISTAKE_LATER_OF_EQUALS},
     {.later_wins_ties = 1}},
    {{.says = "drawn as if the first sphere were missing"}, {.skip_first = 1}},
    {{.says = "drawn as if the last sphere were missing"}, {.skip_last = 1}},
    {{.says = "drawn as if one sphere too many were asked, the one behind the end of the array"},
     {.one_sphere_more = 1}},
    // and of colours.
    {{.says = "drawn with normals that point away from the centre, seen from inside, too"},
     {.normal_not_turned = 1}},
    {{.says = "drawn with the far sides lit: normals, or the ways to lights, are turned round"},
     {.normal_always_turned = 1}},
    {{.says = "drawn with normals that are not unit vectors"}, {.normal_not_normalised = 1}},
    {{.says =
          "drawn as if a light behind the surface took light away: negative cosines count as 0"},
     {.cosine_not_clamped = 1}},
    {{.says = "drawn as if a light behind the surface lit it: negative cosines count as 0"},
     {.cosine_absolute = 1}},
    {{.says = "drawn with ways to the lights that are not unit vectors"},
     {.to_light_not_normalised = 1}},
    {{.says = "lit by the first light only"}, {.first_light_only = 1}},
    {{.says = "lit by the last light only"}, {.last_light_only = 1}},
    {{.says = "lit by one light too many, the one behind the end of the array"},
     {.one_light_more = 1}},
    {{.says = "drawn without kd"}, {.ignore_kd = 1}},
    {{.says = "drawn without the materials' colours"}, {.ignore_color = 1}},
    {{.says = "drawn without the lights' colours"}, {.ignore_light_color = 1}},
    {{.says = "drawn as if sphere i were of material i: its material is material_ids[i]"},
     {.ignore_material_ids = 1}},
    {{.says = "drawn with a black background"}, {.background_black = 1}},
};

// Where they begin.
enum { FIRST_HIT_MISTAKE = 8, FIRST_COLOR_MISTAKE = 20 };

// An answer that goes through a tree makes other mistakes than one that asks every sphere, though a
// few rays may show the same.
static int is_brute_force(const JobScene3D *scene)
{
    return scene->tree.n_nodes == 0;
}

#define TINY_RADIUS 1e-3f

// As DrawMistaken of picture.h has it.
static Cause draw_mistaken(const void *pointer, int mistake, Image *guess, float *tolerances)
{
    const JobScene3D *scene = pointer;
    if (!is_brute_force(scene) || mistake >= (int)(sizeof mistakes / sizeof *mistakes)) {
        return (Cause){0};
    }
    // Vectors as long as tiny spheres leave nothing but black, as many a mistake does.
    static const OracleRules3D right = {0};
    const OracleRules3D *rules = &mistakes[mistake].rules;
    const int is_tiny =
        scene->scene.n_spheres > 0 && fabsf(scene->scene.spheres[0].radius) < TINY_RADIUS;
    const int is_black =
        is_tiny && (rules->normal_not_normalised || rules->to_light_not_normalised);
    oracle3d_draw(&scene->scene, &scene->camera, is_black ? &right : rules, guess, tolerances,
                  NULL);
    return mistakes[mistake].looks;
}

int job_scene3d_expect(JobScene3D *scene)
{
    const Scene3D *s = &scene->scene;
    ExpectedPicture *expected = &scene->picture.expected;
    const OracleRules3D right = {0};
    const size_t n_pixels = (size_t)s->width * (size_t)s->height;
    const Vec3 background = s->background;
    expected->tolerances = calloc(n_pixels, sizeof *expected->tolerances);
    scene->hits = calloc(n_pixels, sizeof *scene->hits);
    if (expected->tolerances == NULL || scene->hits == NULL) {
        complain("grade: no memory for a picture");
        return -1;
    }
    if (image_create(s->width, s->height, &expected->reference) != 0) {
        return -1;
    }
    oracle3d_draw(s, &scene->camera, &right, &expected->reference, expected->tolerances,
                  scene->hits);
    memcpy(expected->background, (float[]){background.x, background.y, background.z, 1},
           sizeof expected->background);
    expected_picture_recognise(expected, draw_mistaken, scene);
    return 0;
}

// ---- Hits -------------------------------------------------------------------------------------

int hit_is_right(const OracleHit *expected, HitAnswer found)
{
    if (expected->is_ambiguous) {
        return 1;
    }
    if (expected->sphere == ORACLE_NO_SPHERE) {
        return found.sphere == ORACLE_NO_SPHERE && found.t == INFINITY;
    }
    return found.sphere == expected->sphere && fabs(found.t - expected->t) <= expected->t_tolerance;
}

OracleRay job_scene3d_ray(const JobScene3D *scene, int pixel)
{
    static const OracleRules3D right = {0};
    const Scene3D *s = &scene->scene;
    return oracle3d_primary_ray(&scene->camera, pixel % s->width, pixel / s->width, s->width,
                                s->height, &right);
}

// "nothing (t = inf)" or "sphere 3 at t = 4.5".
static Words hit_words(u32 sphere, double t)
{
    return sphere == ORACLE_NO_SPHERE ? words("nothing (t = %.9g)", t)
                                      : words("sphere %u at t = %.9g", sphere, t);
}

// The same of spheres that are found infinitely far away.
static Cause explain_infinite(const JobScene3D *scene, const HitAnswer *found)
{
    int n_missed = 0, n_hit = 0, n_finite = 0;
    for (int pixel = 0; pixel < scene->scene.width * scene->scene.height; pixel++) {
        const OracleHit *hit = &scene->hits[pixel];
        const int is_infinite = found[pixel].sphere != ORACLE_NO_SPHERE && isinf(found[pixel].t);
        n_missed += is_infinite && !hit->is_ambiguous && hit->sphere == ORACLE_NO_SPHERE;
        n_hit += is_infinite && !hit->is_ambiguous && hit->sphere != ORACLE_NO_SPHERE;
        n_finite += !isinf(found[pixel].t);
    }
    return (Cause){.says = n_missed > 0 && n_hit == 0
                               ? "as if a miss, t = inf, were a hit: infinity is not nearer than "
                                 "infinity"
                           : n_hit > 0 && n_missed == 0 && n_finite == 0
                               ? "as if hit.t were never set: it is INFINITY for every hit"
                               : NULL};
}

Cause hit_mistake(int i, OracleRules3D *rules)
{
    const int number = FIRST_HIT_MISTAKE + i;
    if (number >= FIRST_COLOR_MISTAKE) {
        return (Cause){0};
    }
    *rules = mistakes[number].rules;
    return mistakes[number].looks;
}

// The same of spheres that are not told, though they are found: every t is right.
static Cause explain_untold(const JobScene3D *scene, const HitAnswer *found)
{
    int n_hits = 0;
    for (int pixel = 0; pixel < scene->scene.width * scene->scene.height; pixel++) {
        const OracleHit *hit = &scene->hits[pixel];
        const HitAnswer told = {found[pixel].t, hit->sphere};
        if (found[pixel].sphere != ORACLE_NO_SPHERE || !hit_is_right(hit, told)) {
            return (Cause){0};
        }
        n_hits += !isinf(found[pixel].t);
    }
    return (Cause){.says = n_hits > 0 ? "as if hit.sphere were never set: it is NO_SPHERE for "
                                        "every hit"
                                      : NULL};
}

// As hits_follow(), and how many rays hit anything then.
static int follow(const JobScene3D *scene, const HitAnswer *found, const OracleRules3D *rules,
                  int *n_hits)
{
    const Scene3D *s = &scene->scene;
    int explains = 1;
    *n_hits = 0;
    for (int pixel = 0; explains && pixel < s->width * s->height; pixel++) {
        const OracleRay ray = oracle3d_primary_ray(&scene->camera, pixel % s->width,
                                                   pixel / s->width, s->width, s->height, rules);
        const OracleHit hit = oracle3d_nearest(s->spheres, (u32)s->n_spheres, &ray, rules);
        explains = scene->hits[pixel].is_ambiguous || hit_is_right(&hit, found[pixel]);
        *n_hits += hit.sphere != ORACLE_NO_SPHERE;
    }
    return explains;
}

int hits_follow(const JobScene3D *scene, const HitAnswer *found, const OracleRules3D *rules)
{
    int n_hits;
    return follow(scene, found, rules, &n_hits);
}

// What wrong hits look like: the mistake that explains all of them, if one does. Rays and
// colours have no part in them.
static Cause explain_hits(const JobScene3D *scene, const HitAnswer *found)
{
    for (int i = FIRST_HIT_MISTAKE; is_brute_force(scene) && i < FIRST_COLOR_MISTAKE; i++) {
        int n_hits;
        // That nothing at all is hit has many reasons.
        if (follow(scene, found, &mistakes[i].rules, &n_hits) && n_hits > 0) {
            return mistakes[i].looks;
        }
    }
    const Cause infinite = explain_infinite(scene, found);
    return infinite.says != NULL ? infinite : explain_untold(scene, found);
}

const HitAnswer *hits_find(const JobScene3D *scene, int k, const Sections *answers)
{
    const size_t n_pixels = (size_t)scene->scene.width * (size_t)scene->scene.height;
    return job_section_find(answers, "hits", k, n_pixels * sizeof(HitAnswer));
}

int hits_count_wrong(const JobScene3D *scene, const HitAnswer *found)
{
    int n_wrong = 0;
    for (int pixel = 0; pixel < scene->scene.width * scene->scene.height; pixel++) {
        n_wrong += !hit_is_right(&scene->hits[pixel], found[pixel]);
    }
    return n_wrong;
}

Diagnosis hits_judge_as(const JobScene3D *scene, const HitAnswer *found, Cause looks)
{
    const int width = scene->scene.width, height = scene->scene.height;
    const int n_wrong = hits_count_wrong(scene, found);
    if (n_wrong == 0) {
        return NOTHING_WRONG;
    }
    int first = 0;
    while (hit_is_right(&scene->hits[first], found[first])) {
        first++;
    }
    const OracleHit *wanted = &scene->hits[first];
    char *wrong = message_new(
        "%s: the ray of pixel (%d, %d): found %s, expected %s (%d of %d rays are wrong)",
        scene->picture.title, first % width, first / width,
        hit_words(found[first].sphere, found[first].t).text,
        hit_words(wanted->sphere, wanted->t).text, n_wrong, width * height);
    return diagnosis_seen(wrong, looks, EVIDENCE_RAYS);
}

Diagnosis hits_judge(const JobScene3D *scene, const HitAnswer *found)
{
    return hits_judge_as(
        scene, found, hits_count_wrong(scene, found) > 0 ? explain_hits(scene, found) : (Cause){0});
}
