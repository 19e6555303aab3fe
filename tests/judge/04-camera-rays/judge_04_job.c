// Rolling lab 04's job from the seed: see judge_04.h.
#include "judge_04.h"

#include "oracle3d.h"
#include "random3d.h"
#include "scene_vary.h"

// Any view whose direction is a quarter of a unit or longer; its up is of any length, mostly not at
// right angles to it.
static ViewJob roll_view(Random *random)
{
    ViewJob view;
    Vec3 way, aside;
    do {
        view.from = random_point(random, 5);
        view.at = random_point(random, 3);
        view.up = random_point(random, 4);
        way = vec3_minus(view.at, view.from);
        aside = vec3_cross(way, view.up);
    } while (vec3_length(way) < 0.25f || vec3_length(view.up) < 0.25f ||
             vec3_length(aside) < 0.25f * vec3_length(way) * vec3_length(view.up));
    return view;
}

// Squares of these numbers, and their products, are no numbers of float any more.
#define LONG 0x1p66f
#define SHORT 0x1p-70f

// View number i of those along such vectors: the long ones first, as what becomes of them is
// plainer.
static ViewJob view_of_length(int i)
{
    static const float ways[N_LENGTHS] = {LONG, 1, LONG, SHORT, 1, SHORT};
    static const float ups[N_LENGTHS] = {1, LONG, LONG, 1, SHORT, SHORT};
    const Vec3 at = {2, -1, 2}, up = {1, 3, 1};
    return (ViewJob){{0}, vec3_scaled(at, ways[i]), vec3_scaled(up, ups[i])};
}

// View number i of those that look nearly along their up, or against it.
static ViewJob steep_view(int i)
{
    static const Vec3 ups[N_STEEP] = {
        {0x1p-6f, 0, 1}, {0, 0x1p-6f, -1}, {0x1p-10f, 0, -1}, {0, 0x1p-10f, 1}};
    return (ViewJob){{1, 2, 3}, {1, 2, -5}, ups[i]};
}

// The same eye turned round: between them the two see every sign of a direction.
static ViewJob looking_back(ViewJob view)
{
    view.at = vec3_minus(vec3_scaled(view.from, 2), view.at);
    return view;
}

static Camera camera_of(ViewJob job, float fov)
{
    const View view = {.from = job.from, .at = job.at, .up = job.up};
    OracleVector axes[3];
    oracle3d_axes(&view, axes);
    return (Camera){job.from, vector_rounded(axes[0]), vector_rounded(axes[1]),
                    vector_rounded(axes[2]), fov};
}

static PixelJob roll_pixel(Random *random, int i)
{
    const int is_square = i < SQUARE + N_PIXELS, is_oblong = i >= OBLONG;
    const float fov = random_number(random, 0.25, 2.5);
    PixelJob job = {.camera = camera_of(roll_view(random), fov)};
    job.width = (i32)random_integer(random, 2, 300);
    job.height = (i32)random_integer(random, 2, 300);
    if (is_square) {
        job.height = job.width;
    } else if (is_oblong && random_integer(random, 0, 1)) {
        job.height = job.width * 2 + 1;
    } else if (is_oblong) {
        job.width = job.height * 3;
    }
    job.x = (i32)random_integer(random, 0, job.width - 1);
    job.y = (i32)random_integer(random, 0, job.height - 1);
    return job;
}

// A view along positive and negative axes, so that a picture tells what becomes of either.
static ViewJob mixed_view(Random *random)
{
    for (;;) {
        const ViewJob view = roll_view(random);
        const Vec3 way = vec3_minus(view.at, view.from);
        if ((way.x > 0) != (way.y > 0) || (way.y > 0) != (way.z > 0)) {
            return view;
        }
    }
}

static int roll_pictures(Random *random, Job04 *job)
{
    static const int sizes[N_PICTURES][2] = {{96, 64}, {49, 67}, {48, 48}, {48, 48}, {48, 48}};
    static const Vec3 ways[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, -1}};
    static const Vec3 ups[3] = {{0, 0, 1}, {1, 0, 0}, {0, 1, 0}};
    static const char *const names[3] = {"x", "y", "-z"};
    ViewJob view = mixed_view(random);
    int result = 0;
    for (int k = 0; result == 0 && k < N_PICTURES; k++) {
        JobPicture *picture = &job->directions[k];
        const int width = side_vary(random, sizes[k][0]), height = side_vary(random, sizes[k][1]);
        const float fov = random_number(random, 0.5, 1.5);
        SceneJob3D scene = {.width = width, .height = height};
        if (k < ALONG) {
            scene.camera = camera_of(view, fov);
            view = looking_back(view);
            snprintf(picture->title, sizeof picture->title, "directions, %dx%d", width, height);
        } else {
            scene.camera = camera_of((ViewJob){{0}, ways[k - ALONG], ups[k - ALONG]}, fov);
            snprintf(picture->title, sizeof picture->title, "directions, looking along %s",
                     names[k - ALONG]);
        }
        job->scenes[k] = scene;
        result = expect_directions_04(&job->scenes[k], &picture->expected);
    }
    return result;
}

// What the kernel sends for every pixel of every picture. What these do not fill stays as it is
// rolled.
static void take_pixels(Job04 *job)
{
    PixelJob *sent = &job->pixels[SENT];
    for (int k = 0; k < N_PICTURES; k++) {
        const SceneJob3D *scene = &job->scenes[k];
        for (int i = 0; i < scene->width * scene->height; i++) {
            *sent++ = (PixelJob){.x = i % scene->width,
                                 .y = i / scene->width,
                                 .width = scene->width,
                                 .height = scene->height,
                                 .camera = scene->camera};
        }
    }
}

int roll_job_04(void *pointer, Random *random)
{
    Job04 *job = pointer;
    for (int i = 0; i < N_VIEWS; i++) {
        job->views[i] = i >= FIRST_STEEP    ? steep_view(i - FIRST_STEEP)
                        : i >= FIRST_LENGTH ? view_of_length(i - FIRST_LENGTH)
                                            : roll_view(random);
    }
    for (int i = 0; i < N_ALL_PIXELS; i++) {
        job->pixels[i] = roll_pixel(random, i);
        if (i >= FIRST_FAR_EYE) {
            job->pixels[i].camera.eye = (Vec3){4000, -3000, 2500};
        }
    }
    const int result = roll_pictures(random, job);
    take_pixels(job);
    return result;
}

int job_04_write_scene(const void *pointer, int k, FILE *file)
{
    const Job04 *job = pointer;
    return job_section_write(file, k, NULL, &job->scenes[k], sizeof job->scenes[k]) |
           job_title_write(file, k, job->directions[k].title);
}
