// Judge of lab 00: a gradient on several sizes, and the host's functions on the same sizes. Read
// next: judge_00.h.
#include "judge_00.h"

#include "jobs.h"
#include "pattern.h"

#include <math.h>
#include <string.h>

// A device's float division may be off by 2.5 units in the last place (OpenCL 1.2, 7.4), of values
// below 1: 2.5 * 2^-24; twice that is allowed.
#define GRADIENT_ERROR (5 * 0x1p-24f)

// A way of drawing. All zeros is the right one.
typedef struct GradientRules {
    double offset;     // added to each coordinate
    int less;          // taken from each size
    int is_of_launch;  // the sizes are those of the probe's launch
    int is_whole;      // coordinate and size are divided as whole numbers
    int n_steps;       // to how many red and green are rounded down; 0: they are not
    int is_by_other;   // the coordinate is divided by the other size
    int is_right[2];   // red, or green, is drawn as it should be
} GradientRules;

static float gradient_channel(int coordinate, int size, int other, const GradientRules *rules)
{
    size = rules->is_by_other ? other : size;
    const int divisor = rules->is_of_launch ? PROBE_IMAGE_SIDE(size) : size - rules->less;
    const double value = (coordinate + rules->offset) / divisor;
    return (float)(rules->is_whole ? floor(value)
                   : rules->n_steps != 0
                       ? (double)(rules->n_steps * coordinate / divisor) / rules->n_steps
                       : value);
}

static const GradientRules right = {0};

// Draw in double precision.
static void gradient_draw(Image *image, const GradientRules *rules)
{
    const int width = image->width, height = image->height;
    float *pixel = image->pixels;
    for (int y = 0; y < image->height; y++) {
        for (int x = 0; x < image->width; x++, pixel += IMAGE_CHANNELS) {
            pixel[0] = gradient_channel(x, width, height, rules->is_right[0] ? &right : rules);
            pixel[1] = gradient_channel(y, height, width, rules->is_right[1] ? &right : rules);
            pixel[2] = 0.25f;
            pixel[3] = 1;
        }
    }
}

#define HALF_A_PIXEL                                                                               \
    "shifted by half a pixel: the colour is that of the pixel's middle, not of its integer "       \
    "coordinate"

// As DrawMistaken of picture.h has it.
static Cause draw_mistaken(const void *scene, int mistake, Image *guess, float *tolerances)
{
    static const struct {
        Cause looks;
        GradientRules rules;
    } mistakes[] = {
        {{HALF_A_PIXEL, MISTAKE_SHIFTED_HALF}, {.offset = 0.5}},
        {{HALF_A_PIXEL, MISTAKE_SHIFTED_HALF}, {.offset = 0.5, .is_right = {1, 0}}},
        {{HALF_A_PIXEL, MISTAKE_SHIFTED_HALF}, {.offset = 0.5, .is_right = {0, 1}}},
        {{"shifted by one pixel: columns and rows count from 0", MISTAKE_SHIFTED_ONE},
         {.offset = 1}},
        {{.says = "drawn with width and height swapped: red is by width, green by height"},
         {.is_by_other = 1}},
        {{.says = "drawn with green divided by width: it is by height"},
         {.is_by_other = 1, .is_right = {1, 0}}},
        {{.says = "drawn with red divided by height: it is by width"},
         {.is_by_other = 1, .is_right = {0, 1}}},
        {{.says = "drawn as if the last row had the colour 1: height is one too small"},
         {.less = 1, .is_right = {1, 0}}},
        {{.says = "drawn as if the last column had the colour 1: width is one too small"},
         {.less = 1, .is_right = {0, 1}}},
        {{.says =
              "drawn as if the last column and row had the colour 1: the sizes are one too small"},
         {.less = 1}},
        {{.says = "drawn with the size of the launch (get_global_size), which is larger than the "
                  "picture"},
         {.is_of_launch = 1}},
        {{.says = "drawn by whole-number division: x / width is 0 for every pixel"},
         {.is_whole = 1}},
        {{.says = "drawn by whole-number division: red is 0 for every pixel"},
         {.is_whole = 1, .is_right = {0, 1}}},
        {{.says = "drawn by whole-number division: green is 0 for every pixel"},
         {.is_whole = 1, .is_right = {1, 0}}},
        {{.says = "drawn in 255 steps, as a PNG file needs them: the image takes any float"},
         {.n_steps = 255}},
    };
    (void)scene;
    if (mistake >= (int)(sizeof mistakes / sizeof *mistakes)) {
        return (Cause){0};
    }
    gradient_draw(guess, &mistakes[mistake].rules);
    for (int i = 0; i < guess->width * guess->height; i++) {
        tolerances[i] = GRADIENT_ERROR;
    }
    return mistakes[mistake].looks;
}

// What the gradient should be.
static int expect_gradient(int width, int height, JobPicture *gradient)
{
    ExpectedPicture *expected = &gradient->expected;
    snprintf(gradient->title, sizeof gradient->title, "gradient, %dx%d", width, height);
    if (image_create(width, height, &expected->reference) != 0) {
        return -1;
    }
    expected->tolerance = GRADIENT_ERROR;
    expected_picture_recognise(expected, draw_mistaken, NULL);
    gradient_draw(&expected->reference, &right);
    return 0;
}

// As DrawMistaken of picture.h has it, for a pattern.
static Cause pattern_mistaken(const void *scene, int mistake, Image *guess, float *tolerances)
{
    (void)scene;
    if (mistake > 0) {
        return (Cause){0};
    }
    gradient_draw(guess, &right);
    for (int i = 0; i < guess->width * guess->height; i++) {
        tolerances[i] = GRADIENT_ERROR;
    }
    return (Cause){
        .says = "like the gradient: read_back copies what is in the image, whatever that is"};
}

// Colours for read_back, which have to arrive to the bit.
static int draw_pattern(u32 key, int width, int height, ExpectedPicture *pattern)
{
    if (image_create(width, height, &pattern->reference) != 0) {
        return -1;
    }
    expected_picture_recognise(pattern, pattern_mistaken, NULL);
    for (int i = 0; i < width * height * IMAGE_CHANNELS; i++) {
        pattern->reference.pixels[i] = pattern_value(key, (u32)i);
    }
    return 0;
}

static void roll_sizes(Random *random, int sizes[N_SIZES][2])
{
    static const int fixed[][2] = {{64, 48}, {317, 211}, {48, 272}, {1, 1}, {17, 16}, {1, 33}};
    const int n_fixed = sizeof fixed / sizeof *fixed;
    memcpy(sizes, fixed, sizeof fixed);
    for (int k = n_fixed; k < N_SIZES; k++) {
        sizes[k][0] = (int)random_integer(random, 20, 200);
        sizes[k][1] = (int)random_integer(random, 20, 200);
    }
}

static int roll(void *pointer, Random *random)
{
    Job00 *job = pointer;
    int sizes[N_SIZES][2], result = 0;
    roll_sizes(random, sizes);
    for (int k = 0; result == 0 && k < N_SIZES; k++) {
        result = expect_gradient(sizes[k][0], sizes[k][1], &job->gradients[k]);
        job->keys[k] = (u32)random_integer(random, 0, UINT32_MAX);
        result |= draw_pattern(job->keys[k], sizes[k][0], sizes[k][1], &job->patterns[k]);
    }
    return result;
}

static void release(void *pointer)
{
    Job00 *job = pointer;
    for (int k = 0; k < N_SIZES; k++) {
        expected_picture_free(&job->patterns[k]);
    }
}

// ---- Writing ------------------------------------------------------------------------------------

static int write_size(const Job00 *job, int k, FILE *file)
{
    const Image *reference = &job->gradients[k].expected.reference;
    const SceneJob size = {.width = reference->width, .height = reference->height};
    return job_section_write(file, k, NULL, &size, sizeof size) |
           job_title_write(file, k, job->gradients[k].title);
}

static int write_scene(const void *pointer, int k, FILE *file)
{
    const Job00 *job = pointer;
    return write_size(job, k, file) |
           job_section_write(file, k, "pattern", &job->keys[k], sizeof job->keys[k]);
}

// No task needs another: alone each is tried on the same.
static int write_alone(const void *job, const char *task, FILE *file)
{
    int result = 0;
    for (int k = 0; result == 0 && k < N_SIZES; k++) {
        result =
            strcmp(task, "read_back") == 0 ? write_scene(job, k, file) : write_size(job, k, file);
    }
    return result;
}

// ---- The judge ----------------------------------------------------------------------------------

static const JudgeCheck checks[] = {
    {"gradient-picture", "Every pixel has its colour", "gradient", .scene = judge_picture,
     .range = {0, N_SIZES}},
    {"gradient-padding", "Nothing is written outside the picture", "gradient",
     .scene = judge_padding, .range = {0, N_SIZES}},
    {"set_arguments-picture", "The kernel gets width, height and image", "set_arguments",
     .scene = judge_00_arguments, .range = {0, N_SIZES}},
    {"enqueue-covers", "Every pixel of every size is drawn", "enqueue_pixels",
     .scene = judge_00_items, .range = {0, N_SIZES}},
    {"read_back-picture", "The picture arrives on the host", "read_back",
     .scene = judge_00_read_back, .range = {0, N_SIZES}},
};

const Judge judge_00 = {
    .lab = "00-hello-pixels",
    .checks = checks,
    .n_checks = COUNT(checks),
    .job_bytes = sizeof(Job00),
    .roll = roll,
    .release = release,
    .scenes = SCENES(picture_kind, Job00, gradients),
    .scene_steps = {{"picture", "in the kernel gradient", "gradient"},
                    {"arguments", "in set_arguments", "set_arguments"},
                    {"items", "in enqueue_pixels", "enqueue_pixels"},
                    {"readback", "in read_back", "read_back"}},
    .write_scene = write_scene,
    .write_alone = write_alone,
    .adopts = 1,
};
