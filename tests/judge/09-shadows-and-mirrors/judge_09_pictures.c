// What lab 09's scenes look like: right, and with known mistakes.
#include "judge_09.h"

#include "complain.h"

#include <stdlib.h>
#include <string.h>

// ---- Known mistakes -----------------------------------------------------------------------------

// A mistake made by the oracle.
typedef struct Mistake09 {
    Cause looks;
    OracleMirrorRules rules;
} Mistake09;

#define BACKGROUND_ALONE                                                                           \
    "drawn as if the background took the place of the light that came before it: it is added, by " \
    "its weight"
#define NOTHING_NEAR                                                                               \
    "drawn as if mirrored rays hit nothing near: they start at the surface's point, and t_min "    \
    "stays as it is"
#define FOLLOWED_TOO_FAR                                                                           \
    "drawn without the cut-off, or with one a ray too late: is the weight compared with "          \
    "LEAST_WEIGHT, and after ks has made it less?"
#define LESS_FOLLOWED                                                                              \
    "drawn as if the end were above LEAST_WEIGHT: light that counts a little more is followed, "   \
    "too"

#define AT_MOST(words, n)                                                                          \
    {                                                                                              \
        {.says = "drawn with " words " mirrors at most: max_bounces may be more"},                 \
        {                                                                                          \
            .most_bounces = (n)                                                                    \
        }                                                                                          \
    }

static const Mistake09 mistakes[] = {
    {{.says = "drawn without shadows: light is added although something stands between"},
     {.no_shadows = 1}},
    {{.says = "drawn with light where something stands between, and not where nothing does"},
     {.only_shadows = 1}},
    {{.says = "drawn as if what stands behind a light cast a shadow: the ray ends at the light"},
     {.endless_light = 1}},
    // Where they are nearly black, one light of several may be all that shows of them.
    {{.says =
          "drawn as if surfaces that scatter little were black: where light is bright, they show"},
     {.least_kd = 0x1p-10}},
    {{.says = "lit by the first light only"}, {.first_light_only = 1}},
    {{.says = "drawn as if one light that does not arrive took the others with it"},
     {.one_dark_all_dark = 1}},
    {{.says = "drawn with one mirror more than allowed"}, {.more_bounces = 1}},
    {{.says = "drawn with one mirror less than allowed"}, {.more_bounces = -1}},
    {{.says = "drawn with the background behind one mirror more than allowed: the end is asked "
              "before the next ray is traced"},
     {.more_bounces = 1, .last_is_dark = 1}},
    {{.says = "drawn as if what is hit after max_bounces mirrors had no light of its own: it adds "
              "that, and no more"},
     {.last_is_dark = 1}},
    {{.says = "drawn as if the light of each hit took the place of what came before it: it is "
              "added"},
     {.replaces = 1}},
    {{.says = "drawn as if the ray went on where it was: a mirror sends it elsewhere, and that is "
              "where it hits next"},
     {.turn = TURN_NONE}},
    {{.says = "drawn as if mirrored rays went along the normal"}, {.turn = TURN_ALONG_NORMAL}},
    {{.says = "drawn as if mirrored rays started at the eye: they start where the mirror is"},
     {.from_the_eye = 1}},
    AT_MOST("five", 5),
    AT_MOST("seven", 7),
    AT_MOST("eight", 8),
    AT_MOST("ten", 10),
    AT_MOST("16", 16),
    AT_MOST("20", 20),
    AT_MOST("32", 32),
    AT_MOST("50", 50),
    AT_MOST("64", 64),
    AT_MOST("100", 100),
    AT_MOST("128", 128),
    {{.says = "drawn as if a mirror that no light reaches were the end: it mirrors all the same"},
     {.dark_ends = 1}},
    {{.says = FOLLOWED_TOO_FAR}, {.no_cut_off = 1}},
    {{.says = FOLLOWED_TOO_FAR}, {.cut_off_late = 1}},
    // Where weights are just the least both look the same: a larger end shows in scenes before.
    {{.says = "drawn as if a weight of LEAST_WEIGHT itself were the end: it goes on"},
     {.least_ends = 1}},
    {{.says = LESS_FOLLOWED}, {.least_weight = 1.0 / 255}},
    {{.says = LESS_FOLLOWED}, {.least_weight = 0.01}},
    {{.says = LESS_FOLLOWED}, {.least_weight = 0.1}},
    {{.says = NOTHING_NEAR}, {.mirrors_see_nothing = 1}},
    {{.says = NOTHING_NEAR}, {.mirror_t_min = 0.25}},
    {{.says = NOTHING_NEAR}, {.mirror_t_min = 0.1}},
    {{.says = NOTHING_NEAR}, {.mirror_t_min = 0.01}},
    {{.says = NOTHING_NEAR}, {.mirror_t_min = 0.001}},
    {{.says = "drawn as if the background counted in full, also over mirrors"},
     {.background_unweighted = 1}},
    {{.says = BACKGROUND_ALONE}, {.background_replaces = 1}},
    {{.says = BACKGROUND_ALONE}, {.background_replaces = 1, .background_unweighted = 1}},
    {{.says = "drawn as if what is not followed any more were the background: the ray ends there"},
     {.rest_is_background = 1}},
    {{.says = "cut at 1: light may be brighter than that"}, {.cut_at_one = 1}},
    {{.says = "drawn as if the background were black in mirrors"}, {.background_missing = 1}},
    {{.says = "drawn without ks: all light over mirrors counts in full"}, {.weight = WEIGHT_ONE}},
    {{.says = "drawn with ks of the last mirror only: over two of them the product counts"},
     {.weight = WEIGHT_LAST_KS}},
    {{.says = "drawn with ks of the first mirror for all of them: each has its own"},
     {.weight = WEIGHT_FIRST_KS}},
    {{.says = "drawn with ks squared: each mirror counts twice"}, {.weight = WEIGHT_KS_SQUARED}},
    {{.says = "drawn with kd in the place of ks"}, {.weight = WEIGHT_KD}},
    {{.says = "drawn as if a surface's own light counted its own ks: only what comes over it does"},
     {.weight = WEIGHT_OWN_KS}},
    {{.says = "drawn as if a surface's own light counted 1 - ks: it counts in full, as NFF has it"},
     {.weight = WEIGHT_SHARED}},
    {{.says = "drawn as if only what is hit first had light of its own"},
     {.weight = WEIGHT_ONLY_FIRST}},
    {{.says = "drawn with the light of surfaces in full, also over mirrors: ks is missing there"},
     {.weight = WEIGHT_LOCAL_ONE}},
};

// As DrawMistaken of picture.h has it.
static Cause draw_mistaken(const void *pointer, int mistake, Image *guess, float *tolerances)
{
    const MirrorScene *scene = pointer;
    if (mistake >= COUNT(mistakes)) {
        return (Cause){0};
    }
    oracle3d_draw_mirrors(&scene->base.scene, &scene->base.camera, scene->max_bounces,
                          &mistakes[mistake].rules, guess, tolerances);
    return mistakes[mistake].looks;
}

// ---- Alone --------------------------------------------------------------------------------------

// By a mistake's rules, or the right ones, as ray_color sees the stubs: rays leave mirrors
// along the normal.
static void draw_alone(const MirrorScene *scene, OracleMirrorRules rules, Image *image,
                       float *tolerances)
{
    rules.stubs = 1;
    rules.nonce = scene->nonce;
    rules.turn = rules.turn == TURN_RIGHT ? TURN_ALONG_NORMAL : rules.turn;
    oracle3d_draw_mirrors(&scene->base.scene, &scene->base.camera, scene->max_bounces, &rules,
                          image, tolerances);
}

// As DrawMistaken of picture.h has it.
static Cause draw_mistaken_alone(const void *pointer, int mistake, Image *guess, float *tolerances)
{
    if (mistake >= COUNT(mistakes)) {
        return (Cause){0};
    }
    draw_alone(pointer, mistakes[mistake].rules, guess, tolerances);
    return mistakes[mistake].looks;
}

int picture_09_expect_alone(const void *job, int k, ExpectedPicture *expected)
{
    const OracleMirrorRules right = {0};
    const MirrorScene *scene = &((const Job09 *)job)->scenes[k];
    const Scene3D *s = &scene->base.scene;
    const Vec3 background = s->background;
    expected->tolerances = calloc((size_t)s->width * (size_t)s->height, sizeof(float));
    memcpy(expected->background, (float[]){background.x, background.y, background.z, 1},
           sizeof expected->background);
    if (expected->tolerances == NULL ||
        image_create(s->width, s->height, &expected->reference) != 0) {
        return -1;
    }
    draw_alone(scene, right, &expected->reference, expected->tolerances);
    expected_picture_recognise(expected, draw_mistaken_alone, scene);
    return 0;
}

// ---- What is expected ---------------------------------------------------------------------------

int picture_09_expect(MirrorScene *scene)
{
    const Scene3D *s = &scene->base.scene;
    const OracleMirrorRules right = {0};
    ExpectedPicture *expected = &scene->base.picture.expected;
    const size_t n_pixels = (size_t)s->width * (size_t)s->height;
    const Vec3 background = s->background;
    expected->tolerances = calloc(n_pixels, sizeof *expected->tolerances);
    if (expected->tolerances == NULL) {
        complain("grade: no memory for a picture");
        return -1;
    }
    if (image_create(s->width, s->height, &expected->reference) != 0) {
        return -1;
    }
    oracle3d_draw_mirrors(s, &scene->base.camera, scene->max_bounces, &right, &expected->reference,
                          expected->tolerances);
    memcpy(expected->background, (float[]){background.x, background.y, background.z, 1},
           sizeof expected->background);
    expected_picture_recognise(expected, draw_mistaken, scene);
    return 0;
}
