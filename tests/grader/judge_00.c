// Judge of lab 00: a gradient on several sizes, whole and as read back.
#include "judge.h"

#include "job_scene.h"
#include "jobs.h"
#include "message.h"

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
    JobScene scenes[N_SIZES];
} Job;

// What the gradient should be, in double precision. A device's float division may be off by 2.5
// units in the last place (OpenCL 1.2, 7.4), of values below 1: 2.5 * 2^-24; twice that is allowed.
static int expect_gradient(JobScene *scene)
{
    ExpectedPicture *expected = &scene->expected;
    if (image_create(scene->scene.width, scene->scene.height, &expected->reference) != 0) {
        return -1;
    }
    expected->tolerance = 5 * 0x1p-24f;
    float *pixel = expected->reference.pixels;
    for (int y = 0; y < scene->scene.height; y++) {
        for (int x = 0; x < scene->scene.width; x++, pixel += IMAGE_CHANNELS) {
            pixel[0] = (float)((double)x / scene->scene.width);
            pixel[1] = (float)((double)y / scene->scene.height);
            pixel[2] = 0.25f;
            pixel[3] = 1;
        }
    }
    return 0;
}

static void job_free(void *pointer)
{
    Job *job = pointer;
    for (int k = 0; k < N_SIZES; k++) {
        job_scene_free(&job->scenes[k]);
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
        JobScene *scene = &job->scenes[k];
        scene->scene.width = sizes[k][0];
        scene->scene.height = sizes[k][1];
        snprintf(scene->title, sizeof scene->title, "gradient, %dx%d", sizes[k][0], sizes[k][1]);
        result = expect_gradient(scene);
        result |= job_scene_write(scene, k, file);
    }
    if (result != 0 && job != NULL) {
        job_free(job);
        job = NULL;
    }
    return job;
}

static Verdict judge_covers(const Job *job, const Sections *answers)
{
    for (int k = 0; k < N_SIZES; k++) {
        const JobScene *scene = &job->scenes[k];
        const ProbeImage own = job_scene_answer(scene, k, answers);
        if (own.pixels == NULL) {
            return verdict_missing;
        }
        char *message = picture_judge_written(own, scene->scene.width, scene->scene.height);
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
        const JobScene *scene = &job->scenes[k];
        const Image *reference = &scene->expected.reference;
        char name[SECTION_NAME_BYTES];
        snprintf(name, sizeof name, "readback.%d", k);
        const size_t n_floats =
            (size_t)reference->width * (size_t)reference->height * IMAGE_CHANNELS;
        const ProbeImage own = {sections_find(answers, name, n_floats * sizeof(float)),
                                reference->width, reference->height};
        if (own.pixels == NULL) {
            return verdict_missing;
        }
        // The array was all NaN; one left in the last pixel says that the copy stopped early.
        if (isnan(own.pixels[n_floats - 1])) {
            return verdict_of(
                message_new("%s: the array on the host was not filled to its end: pixel "
                            "(%d, %d) is untouched",
                            scene->title, reference->width - 1, reference->height - 1));
        }
        char *wrong = picture_judge(own, &scene->expected);
        if (wrong != NULL) {
            char *message = message_new("%s, read back: %s", scene->title, wrong);
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
        return job_scenes_judge_padding(job->scenes, N_SIZES, answers);
    case ENQUEUE_COVERS:
        return judge_covers(job, answers);
    case READ_BACK_PICTURE:
        return judge_read_back(job, answers);
    default:
        return job_scenes_judge(job->scenes, 0, N_SIZES, answers);
    }
}

static void adopt(void *pointer, const Sections *answers)
{
    Job *job = pointer;
    for (int k = 0; k < N_SIZES; k++) {
        job_scene_adopt(&job->scenes[k], k, answers);
    }
}

static void add_pictures(const void *pointer, const Sections *answers, Result *result)
{
    const Job *job = pointer;
    job_scenes_add_pictures(job->scenes, N_SIZES, answers, result);
}

const Judge judge_00 = {
    "00-hello-pixels", checks, sizeof checks / sizeof *checks, job_new, job_free, judge, adopt,
    add_pictures,
};
