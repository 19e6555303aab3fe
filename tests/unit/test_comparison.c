// Comparing pictures through the judges: each hole of the usual tools, closed in every lab that
// draws. A comparison by mean error passes NaN, one by a hash of the visible part another size, one
// by statistics a constant picture; here each fails with its own message.
//
// The answers are the right ones but for one section "picture.K". Read next: right_answers.h.
#include "judge.h"
#include "right_answers.h"
#include "surroundings.h"
#include "told.h"

#include <criterion/parameterized.h>
#include <math.h>

TestSuite(comparison);

// A lab that draws, and one of its pictures, of a scene where something is to be seen.
typedef struct DrawnLab {
    const char *name;
    int number, k;
} DrawnLab;

static const DrawnLab drawn_labs[] = {
    {"00-hello-pixels", 0, 1},        {"01-naive-2d", 1, 2}, {"03-kdtree-2d-render", 3, 3},
    {"04-camera-rays", 4, 0},         {"05-spheres", 5, 0},  {"07-kdtree-3d-trace", 7, 4},
    {"09-shadows-and-mirrors", 9, 4}, {"10-realtime", 10, 2}};
enum { N_DRAWN_LABS = sizeof drawn_labs / sizeof *drawn_labs };

// ---- Right answers but for one picture ----------------------------------------------------------

typedef struct Case {
    const Judge *judge;
    Job *job;
    Sections job_file, right;
    char name[SECTION_NAME_BYTES];  // of the section of the picture
    const float *pixels;            // the right ones: [image height][image width][4]
    size_t n_bytes;
    int is_flat;        // of circles, with a background; else of spheres
    int width, height;  // of the picture
    int image_width, image_height;
    int first_check;  // that expect_fault() asks
} Case;

static Case case_open(const DrawnLab *lab)
{
    Case c = {.judge = judge_of(lab->name)};
    Writer writer;
    writer_open(&writer);
    c.job = job_new(c.judge, 1, writer.file);
    c.job_file = writer_close(&writer);
    cr_assert_not_null(c.job);
    c.right = right_answers(lab->name, 1);
    snprintf(c.name, sizeof c.name, "picture.%d", lab->k % 100);
    c.pixels = sections_find_any(&c.right, c.name, &c.n_bytes);
    size_t n_bytes;
    const void *scene = sections_find_any(&c.job_file, numbered("scene", lab->k, NULL), &n_bytes);
    const SceneJob *flat = scene;
    const SceneJob3D *deep = scene;
    c.is_flat = n_bytes == sizeof *flat;
    c.width = c.is_flat ? flat->width : deep->width;
    c.height = c.is_flat ? flat->height : deep->height;
    c.image_width = PROBE_IMAGE_SIDE(c.width);
    c.image_height = PROBE_IMAGE_SIDE(c.height);
    return c;
}

static void case_close(Case *c)
{
    job_free(c->job);
    sections_free(&c->right);
    sections_free(&c->job_file);
}

// The right answers with another section in the picture's place.
static Sections with_picture(const Case *c, const void *bytes, size_t n_bytes)
{
    Writer writer;
    writer_open(&writer);
    for (size_t at = 0; at < c->right.n_bytes;) {
        const char *name = (const char *)c->right.bytes + at;
        uint64_t n;
        memcpy(&n, c->right.bytes + at + SECTION_NAME_BYTES, sizeof n);
        const unsigned char *content = c->right.bytes + at + SECTION_NAME_BYTES + sizeof n;
        const int is_picture = strcmp(name, c->name) == 0;
        answer(&writer, name, is_picture ? bytes : content, is_picture ? n_bytes : (size_t)n);
        at += SECTION_NAME_BYTES + sizeof n +
              (n + SECTION_ALIGNMENT - 1) / SECTION_ALIGNMENT * SECTION_ALIGNMENT;
    }
    return writer_close(&writer);
}

// Some check fails, and says so. Asked first is the one that did the last time, as judging is slow
// with sanitizers.
static void expect_fault(Case *c, const void *bytes, size_t n_bytes, const char *says)
{
    Sections answers = with_picture(c, bytes, n_bytes);
    const int n = c->judge->n_checks;
    int n_failed = 0, is_said = 0;
    for (int i = 0; i < n && !is_said; i++) {
        const int check = (c->first_check + i) % n;
        const Verdict verdict = job_judge(c->job, check, &answers);
        char *message = told(verdict.diagnosis);
        n_failed += verdict.kind == VERDICT_FAILED;
        is_said = message != NULL && strstr(message, says) != NULL;
        if (is_said) {
            cr_expect_eq(verdict.kind, VERDICT_FAILED);
            c->first_check = check;
        }
        free(message);
    }
    cr_expect(is_said, "%s: %d checks failed, none said \"%s\"", c->judge->lab, n_failed, says);
    sections_free(&answers);
}

// A copy of the right picture that a test may spoil.
static float *pixels_copy(const Case *c)
{
    float *pixels = malloc(c->n_bytes);
    memcpy(pixels, c->pixels, c->n_bytes);
    return pixels;
}

static float *pixel_at(const Case *c, float *pixels, int x, int y)
{
    return pixels + (y * c->image_width + x) * IMAGE_CHANNELS;
}

// One colour everywhere inside the picture.
static void picture_fill(const Case *c, float *pixels, const float color[IMAGE_CHANNELS])
{
    for (int y = 0; y < c->height; y++) {
        for (int x = 0; x < c->width; x++) {
            memcpy(pixel_at(c, pixels, x, y), color, IMAGE_CHANNELS * sizeof *color);
        }
    }
}

// ---- The holes ----------------------------------------------------------------------------------

static void what_is_no_number_fails(Case *c)
{
    static const struct {
        float value;
        const char *says;
    } values[] = {{NAN, "not a number in places"},
                  {-NAN, "not a number in places"},
                  {INFINITY, "infinite in places"},
                  {-INFINITY, "infinite in places"}};
    for (size_t i = 0; i < sizeof values / sizeof *values; i++) {
        const float value = values[i].value;
        float *pixels = pixels_copy(c);
        pixel_at(c, pixels, c->width - 1, c->height / 2)[2] = value;
        expect_fault(c, pixels, c->n_bytes, values[i].says);
        picture_fill(c, pixels, (float[]){value, value, value, value});
        expect_fault(c, pixels, c->n_bytes, values[i].says);
        free(pixels);
    }
}

static void another_size_fails(Case *c)
{
    float *larger = calloc(2, c->n_bytes);
    memcpy(larger, c->pixels, c->n_bytes);
    const size_t row_bytes = (size_t)c->image_width * IMAGE_CHANNELS * sizeof(float);
    expect_fault(c, c->pixels, c->n_bytes - row_bytes, "a picture of another size");
    expect_fault(c, c->pixels, row_bytes, "a picture of another size");
    expect_fault(c, larger, c->n_bytes + row_bytes, "a picture of another size");
    expect_fault(c, larger, c->n_bytes + 4, "a picture of another size");
    expect_fault(c, c->pixels, 0, "a picture of another size");
    free(larger);
}

static void other_channels_fail(Case *c)
{
    static const char *const says[] = {
        NULL, "a picture of 1 channels", "a picture of 2 channels", "a picture of 3 channels",
        NULL, "a picture of 5 channels"};
    const size_t n_pixels = c->n_bytes / (IMAGE_CHANNELS * sizeof(float));
    float *packed = calloc(n_pixels, 5 * sizeof *packed);
    for (size_t n = 1; n <= 5; n++) {
        for (size_t i = 0; i < n_pixels * n; i++) {
            packed[i] = i % n < IMAGE_CHANNELS ? c->pixels[i / n * IMAGE_CHANNELS + i % n] : 1;
        }
        if (n != IMAGE_CHANNELS) {
            expect_fault(c, packed, n_pixels * n * sizeof *packed, says[n]);
        }
    }
    free(packed);
}

// As many bytes, but in rows as long as the picture is high.
static void swapped_sides_fail(Case *c)
{
    float *pixels = calloc(1, c->n_bytes);
    const int n_pixels = c->image_width * c->image_height;
    for (int y = 0; y < c->height; y++) {
        for (int x = 0; x < c->width && y * c->image_height + x < n_pixels; x++) {
            memcpy(pixels + (y * c->image_height + x) * IMAGE_CHANNELS,
                   c->pixels + (y * c->image_width + x) * IMAGE_CHANNELS,
                   IMAGE_CHANNELS * sizeof *pixels);
        }
    }
    if (c->width != c->height) {
        expect_fault(c, pixels, c->n_bytes, "pixels differ");
    }
    free(pixels);
}

static void a_constant_picture_fails(Case *c)
{
    float *pixels = pixels_copy(c);
    picture_fill(c, pixels, (float[]){0.5f, 0.5f, 0.5f, 1});
    expect_fault(c, pixels, c->n_bytes, "it looks of one colour everywhere");
    picture_fill(c, pixels, (float[]){UNWRITTEN, UNWRITTEN, UNWRITTEN, UNWRITTEN});
    expect_fault(c, pixels, c->n_bytes, "nobody wrote pixel (0, 0)");
    // The colour that is right on average.
    double mean[IMAGE_CHANNELS] = {0};
    for (int y = 0; y < c->height; y++) {
        for (int x = 0; x < c->width; x++) {
            for (int channel = 0; channel < IMAGE_CHANNELS; channel++) {
                mean[channel] +=
                    (double)c->pixels[(y * c->image_width + x) * IMAGE_CHANNELS + channel];
            }
        }
    }
    float color[IMAGE_CHANNELS];
    for (int channel = 0; channel < IMAGE_CHANNELS; channel++) {
        color[channel] = (float)(mean[channel] / (c->width * c->height));
    }
    picture_fill(c, pixels, color);
    expect_fault(c, pixels, c->n_bytes, "it looks of one colour everywhere");
    free(pixels);
}

// ---- Black --------------------------------------------------------------------------------------

// Lab 01's picture number 5 shows no circles at all: nothing but (0, 0, 0, 0) is right there.
Test(comparison, black_against_black)
{
    Case c = case_open(&(DrawnLab){"01-naive-2d", 1, 5});
    for (int y = 0; y < c.height; y++) {
        for (int x = 0; x < c.width * IMAGE_CHANNELS; x++) {
            cr_assert_eq(c.pixels[y * c.image_width * IMAGE_CHANNELS + x], 0);
        }
    }
    float *pixels = pixels_copy(&c);
    picture_fill(&c, pixels, (float[]){0, 0, 0, 1});
    expect_fault(&c, pixels, c.n_bytes, "right but for the background");
    picture_fill(&c, pixels, (float[]){NAN, NAN, NAN, NAN});
    expect_fault(&c, pixels, c.n_bytes, "not a number in places");
    picture_fill(&c, pixels, (float[]){-0.0f, 0, 0, 0});
    Sections answers = with_picture(&c, pixels, c.n_bytes);
    for (int i = 0; i < c.judge->n_checks; i++) {
        const Verdict verdict = job_judge(c.job, i, &answers);
        char *message = told(verdict.diagnosis);
        cr_expect_eq(verdict.kind, VERDICT_PASSED, "%s", message);
        free(message);
    }
    sections_free(&answers);
    free(pixels);
    case_close(&c);
}

static void black_against_a_scene_fails(Case *c)
{
    float *pixels = pixels_copy(c);
    picture_fill(c, pixels, (float[]){0, 0, 0, 0});
    expect_fault(c, pixels, c->n_bytes,
                 c->is_flat ? "it looks empty: nothing but the background"
                            : "it looks of one colour everywhere");
    free(pixels);
}

// ---- All of them --------------------------------------------------------------------------------

// Each lab is a test, and so a process, of its own: its number in the list. All holes are tried on
// one job, as drawing it and working out what is right takes longer than judging.
ParameterizedTestParameters(comparison, every_hole_is_closed)
{
    static int numbers[N_DRAWN_LABS];
    for (int i = 0; i < N_DRAWN_LABS; i++) {
        numbers[i] = i;
    }
    return cr_make_param_array(int, numbers, N_DRAWN_LABS);
}

ParameterizedTest(const int *drawn, comparison, every_hole_is_closed)
{
    Case c = case_open(&drawn_labs[*drawn]);
    what_is_no_number_fails(&c);
    another_size_fails(&c);
    other_channels_fail(&c);
    swapped_sides_fail(&c);
    a_constant_picture_fails(&c);
    black_against_a_scene_fails(&c);
    case_close(&c);
}
