// Judge of lab 00: a gradient on several sizes, whole and as read back.
#include "judge.h"

#include "job_picture.h"
#include "job_sections.h"
#include "jobs.h"
#include "message.h"
#include "random.h"

#include <math.h>
#include <stdlib.h>

enum {
    GRADIENT_PICTURE,
    GRADIENT_PADDING,
    SET_ARGUMENTS_PICTURE,
    ENQUEUE_COVERS,
    READ_BACK_PICTURE
};

static const Check checks[] = {
    [GRADIENT_PICTURE] = {"gradient-picture", "Every pixel has its colour", "gradient", 30},
    [GRADIENT_PADDING] = {"gradient-padding", "Nothing is written outside the picture", "gradient",
                          10},
    [SET_ARGUMENTS_PICTURE] = {"set_arguments-picture", "The kernel gets width, height and image",
                               "set_arguments", 20},
    [ENQUEUE_COVERS] = {"enqueue-covers", "Every pixel of every size is drawn", "enqueue_pixels",
                        20},
    [READ_BACK_PICTURE] = {"read_back-picture", "The picture arrives on the host", "read_back", 20},
};

// Multiples of the work-group and not, higher than wide, a single pixel; the last two from the
// seed.
enum { N_SIZES = 7 };

typedef struct Job {
    JobPicture gradients[N_SIZES];
    JobPicture *pictures[N_SIZES];  // the gradients
} Job;

// A device's float division may be off by 2.5 units in the last place (OpenCL 1.2, 7.4), of values
// below 1: 2.5 * 2^-24; twice that is allowed.
#define GRADIENT_ERROR (5 * 0x1p-24f)

// Draw in double precision, with `offset` added to each coordinate and `less` taken from each size:
// both are 0 in the right picture.
static void gradient_draw(Image *image, double offset, int less)
{
    float *pixel = image->pixels;
    for (int y = 0; y < image->height; y++) {
        for (int x = 0; x < image->width; x++, pixel += IMAGE_CHANNELS) {
            pixel[0] = (float)((x + offset) / (image->width - less));
            pixel[1] = (float)((y + offset) / (image->height - less));
            pixel[2] = 0.25f;
            pixel[3] = 1;
        }
    }
}

// As DrawMistaken of picture.h has it.
static const char *draw_mistaken(const void *scene, int mistake, Image *guess, float *tolerances)
{
    static const struct {
        const char *looks;
        double offset;
        int less;
    } mistakes[] = {
        {"shifted by half a pixel: the colour is that of the pixel's middle, not of its integer "
         "coordinate",
         0.5, 0},
        {"drawn as if the last column and row had the colour 1: the sizes are one too small", 0, 1},
    };
    (void)scene;
    if (mistake >= (int)(sizeof mistakes / sizeof *mistakes)) {
        return NULL;
    }
    gradient_draw(guess, mistakes[mistake].offset, mistakes[mistake].less);
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
    expected->draw_mistaken = draw_mistaken;
    gradient_draw(&expected->reference, 0, 0);
    return 0;
}

static void job_free(void *pointer)
{
    Job *job = pointer;
    for (int k = 0; k < N_SIZES; k++) {
        expected_picture_free(&job->gradients[k].expected);
    }
    free(job);
}

static void *job_new(uint64_t seed, FILE *file)
{
    Random random = {seed};
    int sizes[N_SIZES][2] = {{64, 48}, {317, 211}, {48, 64}, {1, 1}, {17, 16}};
    for (int k = N_SIZES - 2; k < N_SIZES; k++) {
        sizes[k][0] = (int)random_integer(&random, 20, 200);
        sizes[k][1] = (int)random_integer(&random, 20, 200);
    }
    Job *job = calloc(1, sizeof *job);
    int result = job == NULL ? -1 : 0;
    for (int k = 0; result == 0 && k < N_SIZES; k++) {
        const SceneJob size = {.width = sizes[k][0], .height = sizes[k][1]};
        job->pictures[k] = &job->gradients[k];
        result = expect_gradient(size.width, size.height, &job->gradients[k]);
        result |= job_section_write(file, k, NULL, &size, sizeof size);
        result |= job_title_write(file, k, job->gradients[k].title);
    }
    if (result != 0 && job != NULL) {
        job_free(job);
        job = NULL;
    }
    return job;
}

// One work-item a pixel, and around the picture at most one group in each direction: the margin of
// the probe's image. NULL when it is so.
static char *judge_items(const JobPicture *gradient, const u32 *n_items)
{
    const int width = gradient->expected.reference.width;
    const int height = gradient->expected.reference.height;
    const size_t side = (size_t)PROBE_IMAGE_SIDE(width);
    for (int y = 0; y < height; y++) {
        for (int x = 0; x < width; x++) {
            const u32 n = n_items[(size_t)y * side + (size_t)x];
            if (n != 1) {
                return message_new("%s: pixel (%d, %d) has %u work-items, expected one",
                                   gradient->title, x, y, n);
            }
        }
    }
    const u32 n_far = n_items[side * (size_t)PROBE_IMAGE_SIDE(height)];
    return n_far == 0
               ? NULL
               : message_new("%s: %u work-items stand more than one group beyond the picture: "
                             "is the size rounded up to the next multiple of the group's?",
                             gradient->title, n_far);
}

static Verdict judge_covers(const Job *job, const Sections *answers)
{
    for (int k = 0; k < N_SIZES; k++) {
        const JobPicture *gradient = &job->gradients[k];
        const ProbeImage own = job_picture_answer(gradient, k, answers);
        if (own.pixels == NULL) {
            return verdict_missing;
        }
        const Image *reference = &gradient->expected.reference;
        const size_t n_places = (size_t)PROBE_IMAGE_SIDE(reference->width) *
                                (size_t)PROBE_IMAGE_SIDE(reference->height);
        const u32 *n_items =
            job_section_find(answers, "items", k, (n_places + 1) * sizeof *n_items);
        if (n_items == NULL) {
            return verdict_missing;
        }
        char *message = picture_judge_written(own, &gradient->expected);
        message = message != NULL ? message : judge_items(gradient, n_items);
        if (message != NULL) {
            return verdict_of(message);
        }
        // Written, but by the kernel? Where a wrong kernel is to blame, the task is tried with
        // ours.
        message = picture_judge(own, &gradient->expected);
        if (message != NULL) {
            return verdict_of(message);
        }
    }
    return verdict_of(NULL);
}

// What read_back() delivered, compared like a picture without a margin.
static Verdict judge_read_back(const Job *job, const Sections *answers)
{
    for (int k = 0; k < N_SIZES; k++) {
        const JobPicture *gradient = &job->gradients[k];
        const Image *reference = &gradient->expected.reference;
        const size_t n_floats =
            (size_t)reference->width * (size_t)reference->height * IMAGE_CHANNELS;
        const ProbeImage own = {job_section_find(answers, "readback", k, n_floats * sizeof(float)),
                                reference->width, reference->height};
        if (own.pixels == NULL) {
            return verdict_missing;
        }
        // The array was all NaN; one left in the last pixel says that the copy stopped early.
        if (isnan(own.pixels[n_floats - 1])) {
            const float *wanted = image_pixel(reference, own.image_width - 1, own.image_height - 1);
            return verdict_of(message_new(
                "%s: the array on the host was not filled to its end: nobody wrote pixel (%d, %d): "
                "found it untouched, expected (%.4g, %.4g, %.4g, %.4g)",
                gradient->title, reference->width - 1, reference->height - 1, (double)wanted[0],
                (double)wanted[1], (double)wanted[2], (double)wanted[3]));
        }
        char *wrong = picture_judge(own, &gradient->expected);
        if (wrong != NULL) {
            char *message = message_new("%s, read back: %s", gradient->title, wrong);
            free(wrong);
            return verdict_of(message);
        }
    }
    return verdict_of(NULL);
}

static Verdict judge(const void *pointer, int check, const Sections *answers)
{
    const Job *job = pointer;
    switch (check) {
    case GRADIENT_PADDING:
        return job_pictures_judge_padding(job->pictures, N_SIZES, answers);
    case ENQUEUE_COVERS:
        return judge_covers(job, answers);
    case READ_BACK_PICTURE:
        return judge_read_back(job, answers);
    default:
        return job_pictures_judge(job->pictures, 0, N_SIZES, answers);
    }
}

static void adopt(void *pointer, const Sections *answers)
{
    Job *job = pointer;
    job_pictures_adopt(job->pictures, N_SIZES, answers);
}

static void add_pictures(const void *pointer, const Sections *answers, Result *result)
{
    const Job *job = pointer;
    job_pictures_report(job->pictures, N_SIZES, answers, result);
}

const Judge judge_00 = {
    .lab = "00-hello-pixels",
    .checks = checks,
    .n_checks = sizeof checks / sizeof *checks,
    .job_new = job_new,
    .job_free = job_free,
    .judge = judge,
    .adopt = adopt,
    .add_pictures = add_pictures,
};
