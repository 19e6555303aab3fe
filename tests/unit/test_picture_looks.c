// judge/picture: a wrong picture is called by the right name, or by none.
#include "picture_case.h"
#include "picture_looks.h"

#include <math.h>

TestSuite(picture_looks);

// The picture's pixel (x, y) shows the right picture's pixel
//   u = ux * x + uy * y + (uw ? width - 1 : 0) + du, v likewise,
// channel by channel, and nothing where that lies outside.
typedef struct Distortion {
    const char *looks;
    int ux, uy, uw, du, vx, vy, vh, dv;
    int channels[IMAGE_CHANNELS];
} Distortion;

// clang-format off
static const Distortion distortions[] = {
    {"mirrored left to right",                     -1, 0, 1, 0,   0, 1, 0, 0,   {0, 1, 2, 3}},
    {"flipped top to bottom",                       1, 0, 0, 0,   0, -1, 1, 0,  {0, 1, 2, 3}},
    {"turned upside down (flipped in x and y)",    -1, 0, 1, 0,   0, -1, 1, 0,  {0, 1, 2, 3}},
    {"transposed: rows and columns are swapped",    0, 1, 0, 0,   1, 0, 0, 0,   {0, 1, 2, 3}},
    {"shifted by one pixel to the right",           1, 0, 0, -1,  0, 1, 0, 0,   {0, 1, 2, 3}},
    {"shifted by one pixel to the left",            1, 0, 0, 1,   0, 1, 0, 0,   {0, 1, 2, 3}},
    {"shifted by one pixel down",                   1, 0, 0, 0,   0, 1, 0, -1,  {0, 1, 2, 3}},
    {"shifted by one pixel up",                     1, 0, 0, 0,   0, 1, 0, 1,   {0, 1, 2, 3}},
    {"shifted by one pixel to the left and up",     1, 0, 0, 1,   0, 1, 0, 1,   {0, 1, 2, 3}},
    {"right with red and blue swapped",             1, 0, 0, 0,   0, 1, 0, 0,   {2, 1, 0, 3}},
    {"right with red and green swapped",            1, 0, 0, 0,   0, 1, 0, 0,   {1, 0, 2, 3}},
    {"right with green and blue swapped",           1, 0, 0, 0,   0, 1, 0, 0,   {0, 2, 1, 3}},
    {"right with its channels rotated (alpha first)",  1, 0, 0, 0,  0, 1, 0, 0, {3, 0, 1, 2}},
    {"right with its channels reversed (alpha first)", 1, 0, 0, 0,  0, 1, 0, 0, {3, 2, 1, 0}},
};
// clang-format on

static void own_distort(Case *c, const Distortion *d)
{
    for (int y = 0; y < c->height; y++) {
        for (int x = 0; x < c->width; x++) {
            const int u = d->ux * x + d->uy * y + (d->uw ? c->width - 1 : 0) + d->du;
            const int v = d->vx * x + d->vy * y + (d->vh ? c->height - 1 : 0) + d->dv;
            const int is_inside = u >= 0 && v >= 0 && u < c->width && v < c->height;
            for (int channel = 0; channel < IMAGE_CHANNELS; channel++) {
                own_pixel(c, x, y)[channel] =
                    is_inside ? reference_pixel(c, u, v)[d->channels[channel]] : 0;
            }
        }
    }
}

enum { N_SEEDS = 3 };

// Do this with random scenes, wide ones and high ones.
static void with_random_scenes(void (*look)(Case *c, size_t i), size_t n)
{
    for (uint64_t seed = 0; seed < N_SEEDS; seed++) {
        for (int is_high = 0; is_high <= 1; is_high++) {
            Case *c = case_open(is_high ? 64 : 96, is_high ? 96 : 64, seed);
            for (size_t i = 0; i < n; i++) {
                look(c, i);
            }
            case_close(c);
        }
    }
}

static void look_at_distortion(Case *c, size_t i)
{
    own_distort(c, &distortions[i]);
    cr_expect_str_eq(looks_of(c), distortions[i].looks, "found \"%s\", expected \"%s\"",
                     looks_of(c), distortions[i].looks);
    // A few other slips do not hide it.
    own_pixel(c, 30, 30)[0] += 1, own_pixel(c, 31, 40)[1] += 1;
    cr_expect_str_eq(looks_of(c), distortions[i].looks);
}

Test(picture_looks, distortions_are_recognised)
{
    with_random_scenes(look_at_distortion, sizeof distortions / sizeof *distortions);
}

// What a colour becomes that is encoded for a screen, or taken for an encoded one.
static const struct {
    const char *looks;
    double power, scale, shift, line, border;
} gammas[] = {
    {"right but for gamma: the colours were raised to 1 / 2.2, but pictures here are linear",
     1 / 2.2, 1, 0, 0, -1},
    {"right but for gamma: the colours were raised to 2.2, but pictures here are linear", 2.2, 1, 0,
     0, -1},
    {"right but for gamma: the colours were encoded by the sRGB curve, but pictures here are "
     "linear",
     1 / 2.4, 1.055, -0.055, 12.92, 0.0031308},
    {"right but for gamma: the colours were decoded by the sRGB curve, but pictures here are "
     "linear",
     2.4, 1, 0, 1 / 12.92, 0.04045},
};

static void look_at_gamma(Case *c, size_t i)
{
    own_show(c, &c->expected.reference);
    for (int y = 0; y < c->height; y++) {
        for (int x = 0; x < c->width; x++) {
            for (int channel = 0; channel < 3; channel++) {
                const double linear = reference_pixel(c, x, y)[channel];
                const double base = i == 3 ? (linear + 0.055) / 1.055 : linear;
                own_pixel(c, x, y)[channel] =
                    (float)(linear <= gammas[i].border
                                ? gammas[i].line * linear
                                : gammas[i].scale * pow(base, gammas[i].power) + gammas[i].shift);
            }
        }
    }
    cr_expect_str_eq(looks_of(c), gammas[i].looks, "found \"%s\", expected \"%s\"", looks_of(c),
                     gammas[i].looks);
    // A power of another kind is not called by this name.
    for (int y = 0; y < c->height; y++) {
        for (int x = 0; x < c->width; x++) {
            own_pixel(c, x, y)[0] = (float)pow(reference_pixel(c, x, y)[0], 0.6);
        }
    }
    cr_expect_str_eq(looks_of(c), "");
}

Test(picture_looks, gamma_is_recognised)
{
    with_random_scenes(look_at_gamma, sizeof gammas / sizeof *gammas);
}

static const struct {
    const char *looks;
    OracleRules rules;
} mistakes[] = {
    {"drawn as if the boundary did not belong to the circle (strict where it should not be)",
     {.strict_boundary = 1}},
    {"drawn as if of two equal depths the later circle won", {.later_wins_ties = 1}},
    {"drawn as if depth did not matter: the last circle covers the others", {.ignore_depth = 1}},
    {"drawn as if depth did not matter: the first circle keeps the pixel", {.first_wins = 1}},
    {"drawn as if the farthest circle won: the depth test is inverted", {.farthest_wins = 1}},
    {"drawn as if the first circle were missing", {.skip_first = 1}},
    {"drawn as if the last circle were missing", {.skip_last = 1}},
    {"shifted by half a pixel: the sample point is the integer coordinate", {.sample_offset = 0.5}},
    {"shifted by half a pixel: the sample point is the integer coordinate",
     {.sample_offset = -0.5}},
    {"drawn with half the radius", {.diameter = 1}},
};

static void look_at_mistake(Case *c, size_t i)
{
    Image picture;
    cr_assert_eq(image_create(c->width, c->height, &picture), 0);
    oracle2d_draw(c->circles, N_CIRCLES, &mistakes[i].rules, &picture, NULL);
    own_show(c, &picture);
    cr_expect_str_eq(looks_of(c), mistakes[i].looks, "found \"%s\", expected \"%s\"", looks_of(c),
                     mistakes[i].looks);
    // Without the scene nothing is said, rather than something wrong.
    expected_picture_recognise(&c->expected, NULL, NULL);
    cr_expect_str_eq(looks_of(c), "", "found \"%s\" without the scene for mistake %zu", looks_of(c),
                     i);
    job_scene_recognise(&c->scene, &c->expected);
    image_free(&picture);
}

Test(picture_looks, mistakes_are_recognised)
{
    with_random_scenes(look_at_mistake, sizeof mistakes / sizeof *mistakes);
}

static void look_at_two_mistakes(Case *c, size_t i)
{
    static const OracleRules both[] = {{.strict_boundary = 1, .later_wins_ties = 1},
                                       {.skip_first = 1, .first_wins = 1},
                                       {.skip_first = 1, .skip_last = 1},
                                       {.sample_offset = 0.5, .farthest_wins = 1}};
    Image picture;
    cr_assert_eq(image_create(c->width, c->height, &picture), 0);
    oracle2d_draw(c->circles, N_CIRCLES, &both[i], &picture, NULL);
    own_show(c, &picture);
    cr_expect_str_eq(looks_of(c), "", "pair %zu looks \"%s\"", i, looks_of(c));
    image_free(&picture);
}

Test(picture_looks, two_mistakes_are_not_taken_for_one)
{
    with_random_scenes(look_at_two_mistakes, 4);
}

static void look_at_background(Case *c, size_t i)
{
    static const float colours[][IMAGE_CHANNELS] = {{0, 0, 0, 1}, {1, 1, 1, 1}, {0.5f, 0, 0, 0}};
    // What is left to say where it is more than another background.
    static const char *const otherwise[] = {"right but for alpha, which is always 1", "",
                                            "right but for red"};
    own_show(c, &c->expected.reference);
    for (int y = 0; y < c->height; y++) {
        for (int x = 0; x < c->width; x++) {
            if (reference_pixel(c, x, y)[3] == 0) {
                memcpy(own_pixel(c, x, y), colours[i], sizeof colours[i]);
            }
        }
    }
    cr_expect_str_eq(looks_of(c),
                     "right but for the background, which is (0, 0, 0, 0) in all four channels");
    int corner = 0;
    while (reference_pixel(c, corner, 0)[3] != 0) {
        corner++;
    }
    float *value = own_pixel(c, corner, 0);
    *value += 0.25f;
    // It is the first wrong pixel, which a message prints: alpha does not explain it.
    cr_expect_str_eq(looks_of(c), i == 0 ? "" : otherwise[i], "a background of two colours");
    *value -= 0.25f;
    own_pixel(c, 20, 20)[0] += 1;  // in the first circle
    cr_expect_str_eq(looks_of(c), otherwise[i]);
}

Test(picture_looks, a_wrong_background_is_recognised)
{
    with_random_scenes(look_at_background, 3);
}

static void look_at_nothing(Case *c, size_t i)
{
    (void)i;
    own_clear(c);
    for (int y = 0; y < c->height; y++) {
        memset(own_pixel(c, 0, y), 0, (size_t)c->width * IMAGE_CHANNELS * sizeof(float));
    }
    cr_expect_str_eq(looks_of(c), "empty: nothing but the background");
}

Test(picture_looks, an_empty_picture_is_recognised)
{
    with_random_scenes(look_at_nothing, 1);
}

// i random pixels show something else.
static void look_at_few_wrong(Case *c, size_t i)
{
    Random random = {i + 99};
    own_show(c, &c->expected.reference);
    for (size_t n = 0; n <= i; n++) {
        float *pixel = own_pixel(c, (int)random_integer(&random, 0, c->width - 1),
                                 (int)random_integer(&random, 0, c->height - 1));
        pixel[random_integer(&random, 0, 3)] += 0.5f;
    }
    cr_expect_str_eq(looks_of(c), "", "%zu wrong pixels look \"%s\"", i + 1, looks_of(c));
}

Test(picture_looks, a_few_wrong_pixels_look_like_nothing)
{
    with_random_scenes(look_at_few_wrong, 12);
}

// A scene of one circle at (40, 30): little is drawn, so most of any guess is right.
static Case *case_open_sparse(float radius)
{
    Case *c = case_open(96, 64, 1);
    c->circles[0] = (Circle){.x = 40, .y = 30, .radius = radius, .r = 0.25f, .g = 0.5f, .a = 1};
    c->scene.scene.n_circles = 1;
    oracle2d_draw(c->circles, 1, &RIGHT, &c->expected.reference, NULL);
    own_show(c, &c->expected.reference);
    return c;
}

// The boundary of the circle of radius 5 passes through these pixels: a strict comparison loses
// them.
enum { N_RIM = 12 };
static const int rim[N_RIM][2] = {{45, 30}, {43, 34}, {44, 33}, {40, 35}, {35, 30}, {36, 27},
                                  {37, 26}, {40, 25}, {43, 26}, {44, 27}, {37, 34}, {36, 33}};

Test(picture_looks, from_five_wrong_pixels_nothing_is_concluded)
{
    Case *c = case_open_sparse(5);
    // Seen where the first circle is not.
    c->circles[1] = (Circle){.x = 40, .y = 30, .radius = 20, .depth = 1, .r = 0.75f, .a = 1};
    c->scene.scene.n_circles = 2;
    oracle2d_draw(c->circles, 2, &RIGHT, &c->expected.reference, NULL);
    own_show(c, &c->expected.reference);
    for (int i = 0; i < 6; i++) {
        memcpy(own_pixel(c, rim[i][0], rim[i][1]), reference_pixel(c, 50, 30),
               IMAGE_CHANNELS * sizeof(float));
        cr_expect_str_eq(looks_of(c), i < 5 ? "" : mistakes[0].looks, "%d pixels", i + 1);
    }
    case_close(c);
}

Test(picture_looks, what_is_lost_must_be_explained_to_the_last_pixel)
{
    Case *c = case_open_sparse(5);
    for (int i = 0; i < N_RIM; i++) {
        memset(own_pixel(c, rim[i][0], rim[i][1]), 0, IMAGE_CHANNELS * sizeof(float));
        cr_expect_str_eq(looks_of(c), i < N_RIM - 1 ? "" : mistakes[0].looks, "%d pixels", i + 1);
    }
    case_close(c);
}

Test(picture_looks, a_guess_must_explain_what_is_wrong)
{
    Case *c = case_open_sparse(2);
    for (int y = 28; y <= 32; y++) {
        for (int x = 38; x <= 42; x++) {
            float *pixel = own_pixel(c, x, y);
            pixel[0] = pixel[3] > 0 ? 0.75f : 0;
        }
    }
    cr_expect_str_eq(looks_of(c), "", "a small circle in a wrong colour looks \"%s\"", looks_of(c));
    case_close(c);
}

// What is said in words is there as a value, too.
static void expect_kinds(const Case *c, Mistake mistake, Evidence evidence, int has_cause)
{
    Diagnosis diagnosis = picture_judge(c->probe, &c->expected);
    cr_expect_eq(diagnosis.mistake, mistake, "%s: %s", diagnosis.found,
                 mistake_name(diagnosis.mistake));
    cr_expect_eq(diagnosis.evidence, evidence, "%s: %d", diagnosis.found, diagnosis.evidence);
    cr_expect_eq(diagnosis.cause != NULL, has_cause, "%s: %s", diagnosis.found, diagnosis.cause);
    diagnosis_free(&diagnosis);
}

Test(picture_looks, the_kinds_of_what_is_wrong_are_known)
{
    Case *c = case_open(96, 64, 1);
    expect_kinds(c, MISTAKE_NONE, EVIDENCE_VALUES, 0);
    own_pixel(c, 9, 8)[0] += 1;
    expect_kinds(c, MISTAKE_NONE, EVIDENCE_PICTURE, 0);
    own_pixel(c, 9, 8)[0] = INFINITY;
    expect_kinds(c, MISTAKE_NONE, EVIDENCE_PLAIN_PICTURE, 0);
    own_pixel(c, 9, 8)[0] = NAN;
    expect_kinds(c, MISTAKE_NONE, EVIDENCE_PICTURE, 0);
    own_clear(c);
    expect_kinds(c, MISTAKE_UNWRITTEN, EVIDENCE_PICTURE, 0);
    for (int i = 0; i < 96 * 64; i++) {
        memcpy(own_pixel(c, i % 96, i / 96), reference_pixel(c, 95 - i % 96, i / 96),
               IMAGE_CHANNELS * sizeof(float));
    }
    expect_kinds(c, MISTAKE_MIRRORED_X, EVIDENCE_PICTURE, 1);
    case_close(c);
}

// Show the picture of a known mistake. Returns its diagnosis.
static Diagnosis show_mistake(Case *c, size_t i)
{
    Image picture;
    cr_assert_eq(image_create(c->width, c->height, &picture), 0);
    oracle2d_draw(c->circles, N_CIRCLES, &mistakes[i].rules, &picture, NULL);
    own_show(c, &picture);
    image_free(&picture);
    return picture_judge(c->probe, &c->expected);
}

Test(picture_looks, a_known_mistake_is_asked_of_another_picture_by_its_rule)
{
    Case *c = case_open(96, 64, 1);
    Diagnosis strict = show_mistake(c, 0);
    cr_assert_not_null(strict.rule);
    cr_expect_str_eq(strict.rule, mistakes[0].looks);
    cr_expect(picture_may_look(c->probe, &c->expected, strict.rule));
    Diagnosis inverted = show_mistake(c, 4);
    cr_expect_not(picture_may_look(c->probe, &c->expected, strict.rule), "another mistake");
    cr_expect(picture_may_look(c->probe, &c->expected, "not one of the scene's"));
    // A cause that is made of this picture has no rule.
    own_show(c, &c->expected.reference);
    for (int i = 0; i < 96 * 64; i++) {
        own_pixel(c, i % 96, i / 96)[2] = 0.75f;
    }
    Diagnosis blue = picture_judge(c->probe, &c->expected);
    cr_expect_not_null(blue.cause);
    cr_expect_null(blue.rule);
    diagnosis_free(&strict);
    diagnosis_free(&inverted);
    diagnosis_free(&blue);
    case_close(c);
}
