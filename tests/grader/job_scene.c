// Scenes of a job: made from the seed, drawn by the oracle, written for the probe.
#include "job_scene.h"

#include "jobs.h"
#include "message.h"
#include "oracle2d.h"

#include <stdlib.h>
#include <string.h>

int job_scene_random(JobScene *scene, Random *random, int n_circles, int max_radius, int width,
                     int height)
{
    *scene = (JobScene){0};
    snprintf(scene->title, sizeof scene->title, "random scene, %d circles, %dx%d", n_circles, width,
             height);
    if (scene2d_random(n_circles, random_bits(random), 2, (float)max_radius, width, height,
                       &scene->scene) != 0) {
        return -1;
    }
    // Opaque circles would hide who forgets the fourth channel.
    for (int i = 0; i < n_circles; i++) {
        scene->scene.circles[i].a = (float)random_integer(random, 4, 16) / 16;
    }
    return 0;
}

int job_scene_named(JobScene *scene, const char *name, int width, int height)
{
    *scene = (JobScene){0};
    snprintf(scene->title, sizeof scene->title, "scene \"%s\", %dx%d", name, width, height);
    return scene2d_open(name, width, height, &scene->scene);
}

void job_scene_spread_depths(JobScene *scene)
{
    for (int i = 0; i < scene->scene.n_circles; i++) {
        scene->scene.circles[i].depth = 0x1p20f * scene->scene.circles[i].depth - 0x1p19f;
    }
}

int job_scene_expect(JobScene *scene)
{
    const Scene2D *s = &scene->scene;
    ExpectedPicture *expected = &scene->expected;
    const OracleRules right = {0};
    if (image_create(s->width, s->height, &expected->reference) != 0) {
        return -1;
    }
    expected->ambiguous = calloc((size_t)s->width * (size_t)s->height, 1);
    if (expected->ambiguous == NULL) {
        fprintf(stderr, "grade: no memory for a picture\n");
        return -1;
    }
    oracle2d_draw(s->circles, s->n_circles, &right, &expected->reference, expected->ambiguous);
    expected->circles = s->circles;
    expected->n_circles = s->n_circles;
    return 0;
}

int job_scene_grow_tree(JobScene *scene, KdTreeLimits limits)
{
    scene->limits = limits;
    return kdtree2d_build(scene->scene.circles, (u32)scene->scene.n_circles, limits, &scene->tree);
}

// Write section "scene.K.part".
static int write_part(FILE *file, int k, const char *part, const void *bytes, size_t n_bytes)
{
    char name[SECTION_NAME_BYTES];
    snprintf(name, sizeof name, "scene.%d.%s", k, part);
    return section_write(file, name, bytes, n_bytes);
}

// The circles and, behind them, one that must not be asked.
static int write_circles(FILE *file, int k, const Scene2D *scene)
{
    const size_t n = (size_t)scene->n_circles;
    Circle *circles = calloc(n + 1, sizeof *circles);
    if (circles == NULL) {
        fprintf(stderr, "grade: no memory for a scene\n");
        return -1;
    }
    if (n > 0) {
        memcpy(circles, scene->circles, n * sizeof *circles);
    }
    circles[n] = (Circle){.radius = 1e6f,
                          .depth = -1e9f,
                          .r = BEYOND_RED,
                          .g = BEYOND_GREEN,
                          .b = BEYOND_BLUE,
                          .a = 1};
    const int result = write_part(file, k, "circles", circles, (n + 1) * sizeof *circles);
    free(circles);
    return result;
}

int job_scene_write(const JobScene *scene, int k, FILE *file)
{
    const Scene2D *s = &scene->scene;
    const SceneJob job = {s->n_circles, s->width, s->height, scene->limits.maxDepth,
                          scene->limits.targetElementsPerNode};
    char name[SECTION_NAME_BYTES];
    snprintf(name, sizeof name, "scene.%d", k);
    int result = section_write(file, name, &job, sizeof job);
    result |= write_circles(file, k, s);
    const KdTree2D *tree = &scene->tree;
    if (tree->n_nodes > 0) {
        result |= write_part(file, k, "relations", tree->nodes_Relations,
                             tree->n_nodes * sizeof *tree->nodes_Relations);
        result |= write_part(file, k, "flags", tree->nodes_flag,
                             tree->n_nodes * sizeof *tree->nodes_flag);
        result |= write_part(file, k, "boxes", tree->nodes_BBox,
                             tree->n_nodes * sizeof *tree->nodes_BBox);
        result |= write_part(file, k, "map", tree->mapNode2Circles,
                             tree->n_map * sizeof *tree->mapNode2Circles);
    }
    return result;
}

void job_scene_free(JobScene *scene)
{
    expected_picture_free(&scene->expected);
    tree2d_free(&scene->tree);
    scene2d_free(&scene->scene);
}

ProbeImage job_scene_answer(const JobScene *scene, int k, const Sections *answers)
{
    const int image_width = PROBE_IMAGE_SIDE(scene->scene.width);
    const int image_height = PROBE_IMAGE_SIDE(scene->scene.height);
    char name[SECTION_NAME_BYTES];
    snprintf(name, sizeof name, "picture.%d", k);
    const size_t n_bytes =
        (size_t)image_width * (size_t)image_height * IMAGE_CHANNELS * sizeof(float);
    return (ProbeImage){sections_find(answers, name, n_bytes), image_width, image_height};
}

Verdict job_scene_judge(const JobScene *scene, int k, const Sections *answers)
{
    const ProbeImage own = job_scene_answer(scene, k, answers);
    if (own.pixels == NULL) {
        return verdict_missing;
    }
    char *wrong = picture_judge(own, &scene->expected);
    if (wrong == NULL) {
        return verdict_of(NULL);
    }
    char *message = message_new("%s: %s", scene->title, wrong);
    free(wrong);
    return verdict_of(message);
}

Verdict job_scenes_judge(const JobScene *scenes, int first, int n, const Sections *answers)
{
    for (int k = first; k < first + n; k++) {
        const Verdict verdict = job_scene_judge(&scenes[k], k, answers);
        if (verdict.kind != VERDICT_PASSED) {
            return verdict;
        }
    }
    return verdict_of(NULL);
}

Verdict job_scenes_judge_padding(const JobScene *scenes, int n, const Sections *answers)
{
    for (int k = 0; k < n; k++) {
        const ProbeImage own = job_scene_answer(&scenes[k], k, answers);
        if (own.pixels == NULL) {
            return verdict_missing;
        }
        // Drawing too little is no way to keep inside the picture.
        const Scene2D *scene = &scenes[k].scene;
        char *message = picture_judge_padding(own, scene->width, scene->height);
        if (message == NULL) {
            message = picture_judge_written(own, scene->width, scene->height);
        }
        if (message != NULL) {
            return verdict_of(message);
        }
    }
    return verdict_of(NULL);
}

void job_scene_adopt(JobScene *scene, int k, const Sections *answers)
{
    const ProbeImage drawn = job_scene_answer(scene, k, answers);
    Image *reference = &scene->expected.reference;
    for (int y = 0; y < reference->height; y++) {
        memcpy(reference->pixels + (size_t)y * (size_t)reference->width * IMAGE_CHANNELS,
               drawn.pixels + (size_t)y * (size_t)drawn.image_width * IMAGE_CHANNELS,
               (size_t)reference->width * IMAGE_CHANNELS * sizeof(float));
    }
}

void job_scene_add_picture(const JobScene *scene, int k, const Sections *answers, Result *result)
{
    const ProbeImage own = job_scene_answer(scene, k, answers);
    if (result->n_pictures == RESULT_MAX_PICTURES) {
        return;
    }
    PictureResult *picture = &result->pictures[result->n_pictures++];
    const Image *reference = &scene->expected.reference;
    snprintf(picture->title, sizeof picture->title, "%s", scene->title);
    if (image_create(reference->width, reference->height, &picture->reference) == 0) {
        memcpy(picture->reference.pixels, reference->pixels,
               (size_t)reference->width * (size_t)reference->height * IMAGE_CHANNELS *
                   sizeof(float));
    }
    if (own.pixels != NULL) {
        picture_copy(own, reference->width, reference->height, &picture->own);
    }
}

void job_scenes_add_pictures(const JobScene *scenes, int n, const Sections *answers, Result *result)
{
    // Enough to see what is wrong; a page of all of them would only be slower.
    enum { MAX_WRONG = 6, MAX_RIGHT = 3 };
    for (int want_wrong = 1; want_wrong >= 0; want_wrong--) {
        int n_added = 0;
        for (int k = 0; k < n && n_added < (want_wrong ? MAX_WRONG : MAX_RIGHT); k++) {
            const Verdict verdict = job_scene_judge(&scenes[k], k, answers);
            if ((verdict.kind != VERDICT_PASSED) == want_wrong) {
                job_scene_add_picture(&scenes[k], k, answers, result);
                n_added++;
            }
            free(verdict.message);
        }
    }
}
