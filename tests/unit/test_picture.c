// judge/picture: only the right picture passes, and a wrong one is called by the right name.
#include "job_scene.h"
#include "jobs.h"
#include "oracle2d.h"
#include "picture.h"
#include "random.h"
#include "surroundings.h"
#include "told.h"

#include <math.h>

TestSuite(picture);

// ---- A scene, its picture, and a probe's answer -------------------------------------------------

enum { MAX_SIDE = 96, IMAGE_SIDE = PROBE_IMAGE_SIDE(MAX_SIDE), N_CIRCLES = 24 };

typedef struct Case {
    Circle circles[N_CIRCLES];
    JobScene scene;  // they
    ExpectedPicture expected;
    float own[IMAGE_SIDE * IMAGE_SIDE * IMAGE_CHANNELS];
    ProbeImage probe;
    int width, height;
} Case;

static const OracleRules RIGHT = {0};

// Whole centres, radii with whole points on their boundary, few depths: every mistake shows. The
// first and the last circle are nearest of all and apart.
static void circles_draw(Random *random, int width, int height, Circle circles[N_CIRCLES])
{
    for (int i = 0; i < N_CIRCLES; i++) {
        const int is_end = i == 0 || i == N_CIRCLES - 1;
        circles[i] = (Circle){.x = (float)random_integer(random, 0, width - 1),
                              .y = (float)random_integer(random, 0, height - 1),
                              .radius = (float)(is_end ? 5 : 5 * random_integer(random, 1, 3)),
                              .depth = is_end ? 0 : (float)random_integer(random, 1, 4) / 4,
                              .r = (float)random_integer(random, 1, 255) / 255,
                              .g = (float)random_integer(random, 1, 255) / 255,
                              .b = (float)random_integer(random, 1, 255) / 255,
                              .a = 1};
    }
    circles[0].x = circles[0].y = 20;
    circles[N_CIRCLES - 1].x = (float)(width - 21);
    circles[N_CIRCLES - 1].y = (float)(height - 22);
}

static float *own_pixel(Case *c, int x, int y)
{
    return c->own + (y * c->probe.image_width + x) * IMAGE_CHANNELS;
}

static const float *reference_pixel(const Case *c, int x, int y)
{
    return c->expected.reference.pixels + (y * c->width + x) * IMAGE_CHANNELS;
}

// Nobody has written anything yet.
static void own_clear(Case *c)
{
    for (size_t i = 0; i < sizeof c->own / sizeof *c->own; i++) {
        c->own[i] = UNWRITTEN;
    }
}

// The probe's image shows this picture.
static void own_show(Case *c, const Image *picture)
{
    own_clear(c);
    for (int y = 0; y < c->height; y++) {
        memcpy(own_pixel(c, 0, y), picture->pixels + y * c->width * IMAGE_CHANNELS,
               (size_t)c->width * IMAGE_CHANNELS * sizeof(float));
    }
}

// A random scene whose picture is expected and shown.
static Case *case_open(int width, int height, uint64_t seed)
{
    Case *c = calloc(1, sizeof *c);
    Random random = {seed};
    circles_draw(&random, width, height, c->circles);
    cr_assert_eq(image_create(width, height, &c->expected.reference), 0);
    oracle2d_draw(c->circles, N_CIRCLES, &RIGHT, &c->expected.reference, NULL);
    c->scene.scene = (Scene2D){c->circles, N_CIRCLES, width, height};
    job_scene_recognise(&c->scene, &c->expected);
    c->width = width, c->height = height;
    c->probe = (ProbeImage){c->own, PROBE_IMAGE_SIDE(width), PROBE_IMAGE_SIDE(height)};
    own_show(c, &c->expected.reference);
    return c;
}

static void case_close(Case *c)
{
    expected_picture_free(&c->expected);
    free(c);
}

static void expect_right(const Case *c)
{
    cr_expect(picture_is_right(c->probe, &c->expected));
    char *message = told(picture_judge(c->probe, &c->expected));
    cr_expect_null(message, "%s", message);
    free(message);
}

static void expect_wrong(const Case *c, const char *expected)
{
    char *message = told(picture_judge(c->probe, &c->expected));
    cr_expect(message != NULL && strcmp(message, expected) == 0, "found \"%s\", expected \"%s\"",
              message ? message : "(right)", expected);
    free(message);
}

// Nobody wrote n pixels, this one the first of them.
static void expect_unwritten(const Case *c, int x, int y, int n)
{
    const float *pixel = reference_pixel(c, x, y);
    char expected[256];
    snprintf(expected, sizeof expected,
             "nobody wrote pixel (%d, %d) of a %dx%d picture: found nothing, expected (%.4g, %.4g, "
             "%.4g, %.4g) (%d of 6144 pixels were not written)",
             x, y, c->width, c->height, (double)pixel[0], (double)pixel[1], (double)pixel[2],
             (double)pixel[3], n);
    expect_wrong(c, expected);
}

// What the picture is said to look like; "" when nothing is said.
static const char *looks_of(const Case *c)
{
    static char looks[512];
    char *message = told(picture_judge(c->probe, &c->expected));
    cr_assert_not_null(message);
    cr_expect_not(picture_is_right(c->probe, &c->expected));
    const char *at = strstr(message, " it looks ");
    snprintf(looks, sizeof looks, "%s", at ? at + strlen(" it looks ") : "");
    free(message);
    return looks;
}

// ---- Right and wrong ----------------------------------------------------------------------------

Test(picture, an_equal_picture_is_right)
{
    Case *c = case_open(96, 64, 1);
    expect_right(c);
    c->expected.draw_mistaken = NULL;
    expect_right(c);
    case_close(c);
    c = case_open(64, 96, 2);
    expect_right(c);
    case_close(c);
}

Test(picture, one_pixel_is_named_with_both_values)
{
    Case *c = case_open(96, 64, 1);
    memcpy(c->expected.reference.pixels + (63 * 96 + 95) * IMAGE_CHANNELS,
           (float[]){0.25f, 0.5f, 0.125f, 1}, 4 * sizeof(float));
    own_show(c, &c->expected.reference);
    own_pixel(c, 95, 63)[1] = 0.75f;
    expect_wrong(c, "pixel (95, 63): found (0.25, 0.75, 0.125, 1), expected (0.25, 0.5, 0.125, 1) "
                    "(1 of 6144 pixels differ)");
    for (int channel = 0; channel < IMAGE_CHANNELS; channel++) {
        own_show(c, &c->expected.reference);
        own_pixel(c, 3, 2)[channel] = nextafterf(own_pixel(c, 3, 2)[channel], 2);
        char *message = told(picture_judge(c->probe, &c->expected));
        cr_expect(message != NULL && strstr(message, "pixel (3, 2): ") == message);
        free(message);
    }
    // The first in reading order is named, and all are counted.
    own_show(c, &c->expected.reference);
    own_pixel(c, 9, 8)[0] += 1, own_pixel(c, 8, 9)[0] += 1;
    char *message = told(picture_judge(c->probe, &c->expected));
    cr_expect(message != NULL && strstr(message, "pixel (9, 8): ") == message &&
                  strstr(message, " (2 of 6144 pixels differ)") != NULL,
              "%s", message);
    free(message);
    case_close(c);
}

Test(picture, what_is_not_finite_never_passes)
{
    static const struct {
        float value;
        const char *looks;
    } values[] = {{NAN, "not a number in places"},
                  {-NAN, "not a number in places"},
                  {INFINITY, "infinite in places"},
                  {-INFINITY, "infinite in places"}};
    Case *c = case_open(64, 96, 3);
    c->expected.tolerances = calloc(64 * 96, sizeof(float));
    for (int is_ambiguous = 0; is_ambiguous <= 1; is_ambiguous++) {
        for (int j = 0; j < 64 * 96; j++) {
            c->expected.tolerances[j] = is_ambiguous ? INFINITY : 0.5f;
        }
        for (size_t i = 0; i < sizeof values / sizeof *values; i++) {
            for (int channel = 0; channel < IMAGE_CHANNELS; channel++) {
                own_show(c, &c->expected.reference);
                own_pixel(c, 5, 7)[channel] = values[i].value;
                cr_expect_str_eq(looks_of(c), values[i].looks);
            }
            own_show(c, &c->expected.reference);
            for (int j = 0; j < 64 * 96; j++) {
                float *pixel = own_pixel(c, j % 64, j / 64);
                pixel[0] = pixel[1] = pixel[2] = pixel[3] = values[i].value;
            }
            cr_expect_str_eq(looks_of(c), values[i].looks);
        }
    }
    case_close(c);
}

Test(picture, the_tolerance_is_the_last_that_passes)
{
    Case *c = case_open(96, 64, 1);
    c->expected.tolerance = 0.25f;
    float *expected = c->expected.reference.pixels + (3 * 96 + 2) * IMAGE_CHANNELS;
    expected[2] = 0.5f;
    for (int sign = -1; sign <= 1; sign += 2) {
        own_pixel(c, 2, 3)[2] = 0.5f + (float)sign * 0.25f;
        expect_right(c);
        own_pixel(c, 2, 3)[2] = 0.5f + (float)sign * 0.250001f;
        cr_expect_str_eq(looks_of(c), "");
    }
    case_close(c);
}

Test(picture, every_pixel_has_its_tolerance)
{
    Case *c = case_open(96, 64, 1);
    c->expected.tolerances = calloc(96 * 64, sizeof(float));
    c->expected.tolerances[3 * 96 + 2] = 0.25f;
    c->expected.tolerance = 1;  // it counts where there are no others
    own_pixel(c, 2, 3)[2] += 0.25f;
    expect_right(c);
    own_pixel(c, 3, 3)[2] += 0.125f;
    cr_expect_str_eq(looks_of(c), "");
    case_close(c);
}

Test(picture, only_ambiguous_pixels_may_differ)
{
    Case *c = case_open(64, 96, 3);
    c->expected.tolerances = calloc(64 * 96, sizeof(float));
    c->expected.tolerances[7 * 64 + 5] = INFINITY;
    own_pixel(c, 5, 7)[0] += 0.5f;
    expect_right(c);
    own_pixel(c, 7, 5)[0] += 0.5f;
    char *message = told(picture_judge(c->probe, &c->expected));
    cr_expect(message != NULL && strstr(message, "pixel (7, 5): ") == message &&
                  strstr(message, " (1 of 6144 pixels differ)") != NULL,
              "%s", message);
    free(message);
    // Either choice is a colour that somebody wrote.
    own_show(c, &c->expected.reference);
    for (int channel = 0; channel < IMAGE_CHANNELS; channel++) {
        own_pixel(c, 5, 7)[channel] = UNWRITTEN;
    }
    expect_unwritten(c, 5, 7, 1);
    case_close(c);
}

Test(picture, unwritten_pixels_are_told_from_wrong_ones)
{
    Case *c = case_open(96, 64, 1);
    own_clear(c);
    expect_unwritten(c, 0, 0, 6144);
    own_show(c, &c->expected.reference);
    for (int y = 10; y < 13; y++) {
        for (int channel = 0; channel < IMAGE_CHANNELS; channel++) {
            own_pixel(c, 20, y)[channel] = UNWRITTEN;
        }
    }
    expect_unwritten(c, 20, 10, 3);
    own_pixel(c, 50, 50)[0] += 1;
    cr_expect_str_eq(looks_of(c), "");
    case_close(c);
}

// ---- What it looks like -------------------------------------------------------------------------

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

enum { N_SEEDS = 8 };

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

Test(picture, distortions_are_recognised)
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

Test(picture, gamma_is_recognised)
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
    c->expected.draw_mistaken = NULL;
    cr_expect_str_eq(looks_of(c), "", "found \"%s\" without the scene for mistake %zu", looks_of(c),
                     i);
    job_scene_recognise(&c->scene, &c->expected);
    image_free(&picture);
}

Test(picture, mistakes_are_recognised)
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

Test(picture, two_mistakes_are_not_taken_for_one)
{
    with_random_scenes(look_at_two_mistakes, 4);
}

static void look_at_background(Case *c, size_t i)
{
    static const float colours[][IMAGE_CHANNELS] = {{0, 0, 0, 1}, {1, 1, 1, 1}, {0.5f, 0, 0, 0}};
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
    cr_expect_str_eq(looks_of(c), "", "a background of two colours");
    *value -= 0.25f;
    own_pixel(c, 20, 20)[0] += 1;  // in the first circle
    cr_expect_str_eq(looks_of(c), "");
}

Test(picture, a_wrong_background_is_recognised)
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

Test(picture, an_empty_picture_is_recognised)
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

Test(picture, a_few_wrong_pixels_look_like_nothing)
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

Test(picture, from_five_wrong_pixels_nothing_is_concluded)
{
    // The boundary passes through twelve pixels; these are some that a strict comparison loses.
    static const int lost[6][2] = {{45, 30}, {43, 34}, {44, 33}, {40, 35}, {35, 30}, {36, 27}};
    Case *c = case_open_sparse(5);
    for (int i = 0; i < 6; i++) {
        memset(own_pixel(c, lost[i][0], lost[i][1]), 0, IMAGE_CHANNELS * sizeof(float));
        cr_expect_str_eq(looks_of(c), i < 5 ? "" : mistakes[0].looks, "%d pixels", i + 1);
    }
    case_close(c);
}

Test(picture, a_guess_must_explain_what_is_wrong)
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

Test(picture, the_kinds_of_what_is_wrong_are_known)
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

// ---- Around the picture -------------------------------------------------------------------------

static void expect_message(Diagnosis diagnosis, const char *part)
{
    char *message = told(diagnosis);
    cr_expect(part ? message != NULL && strstr(message, part) != NULL : message == NULL,
              "found \"%s\", expected \"%s\"", message ? message : "(nothing)",
              part ? part : "(nothing)");
    free(message);
}

Test(picture, what_is_written_outside_is_found)
{
    // The image is 96 + 16 by 64 + 16 pixels.
    static const int places[][2] = {{96, 0}, {0, 64}, {96, 64}, {111, 79}, {111, 0}, {0, 79}};
    Case *c = case_open(96, 64, 1);
    cr_assert(c->probe.image_width == 112 && c->probe.image_height == 80);
    expect_message(picture_judge_padding(c->probe, 96, 64), NULL);
    for (size_t i = 0; i < sizeof places / sizeof *places; i++) {
        for (int channel = 0; channel < IMAGE_CHANNELS; channel++) {
            float *value = &own_pixel(c, places[i][0], places[i][1])[channel];
            char part[64];
            snprintf(part, sizeof part, "pixel (%d, %d) of a 96x64 picture", places[i][0],
                     places[i][1]);
            *value = channel % 2 ? NAN : 0;
            expect_message(picture_judge_padding(c->probe, 96, 64), part);
            *value = UNWRITTEN;
        }
    }
    expect_message(picture_judge_padding(c->probe, 96, 64), NULL);
    expect_right(c);
    case_close(c);
}

Test(picture, what_nobody_wrote_is_found)
{
    Case *c = case_open(64, 96, 1);
    expect_message(picture_judge_written(c->probe, &c->expected), NULL);
    own_pixel(c, 63, 95)[0] = UNWRITTEN;
    own_pixel(c, 9, 9)[3] = NAN;
    expect_message(picture_judge_written(c->probe, &c->expected), NULL);
    for (int channel = 0; channel < IMAGE_CHANNELS; channel++) {
        own_pixel(c, 63, 95)[channel] = own_pixel(c, 0, 95)[channel] = UNWRITTEN;
    }
    expect_message(picture_judge_written(c->probe, &c->expected),
                   "nobody wrote pixel (0, 95) of a 64x96 picture: found nothing, expected (0, 0, "
                   "0, 0) (2 of 6144");
    own_clear(c);
    expect_message(picture_judge_written(c->probe, &c->expected), "pixel (0, 0) of a 64x96");
    case_close(c);
}

Test(picture, is_copied_without_its_margin)
{
    Case *c = case_open(96, 64, 5);
    Image copy;
    cr_assert_eq(picture_copy(c->probe, 96, 64, &copy), 0);
    cr_expect(copy.width == 96 && copy.height == 64);
    const ImageDifference difference = image_compare(&copy, &c->expected.reference, 0);
    cr_expect(difference.same_size && difference.n_different == 0);
    image_free(&copy);
    case_close(c);
}
