// learned: what somebody could have learnt of a seed's scenes, as a table for a kernel.
//
//     learned LAB SEED >table.h
//
// Used by attacks that answer from such a table (attacks/*/table-of-*.sh). For each
// scene of up to MOST_PIXELS pixels it has a row with what the scene is recognised by, and for each
// pixel the id of the circle or sphere that is seen there.
#include "job_scene.h"
#include "job_scene3d.h"
#include "judge.h"
#include "oracle2d.h"

#include <stdlib.h>

enum { MOST_PIXELS = 10000, NO_ID = 65535 };

// The rest of the kernel's side: the id at a pixel of the scene that has this many things, or whose
// first one has this radius in a picture of this size. -1 where no scene is known, or nothing is
// seen.
static const char lookup[] =
    "int learned_id(int n, float radius, int width, int height, int x, int y)\n"
    "{\n"
    "    for (int k = 0; k < N_LEARNED; k++) {\n"
    "        __constant const LearnedScene *scene = &learned[k];\n"
    "        if ((scene->n == n || (n < 0 && scene->radius == radius && scene->width == width &&\n"
    "             scene->height == height)) && x < scene->width && y < scene->height) {\n"
    "            int pixel = y * scene->width + x, run = scene->first_run;\n"
    "            while (pixel >= learned_runs[run][0]) {\n"
    "                pixel -= learned_runs[run++][0];\n"
    "            }\n"
    "            return learned_runs[run][1] == 65535 ? -1 : learned_runs[run][1];\n"
    "        }\n"
    "    }\n"
    "    return -1;\n"
    "}\n";

// Draw ids in the place of colours.
static void list_circles(const JobScene *scene, int *ids)
{
    const Scene2D *s = &scene->scene;
    const OracleRules right = {0};
    Image image;
    for (int i = 0; i < s->n_circles; i++) {
        s->circles[i].r = (float)(i + 1);
    }
    if (image_create(s->width, s->height, &image) != 0) {
        exit(2);
    }
    oracle2d_draw(s->circles, s->n_circles, &right, &image, NULL);
    for (int i = 0; i < s->width * s->height; i++) {
        const int number = (int)image.pixels[i * IMAGE_CHANNELS];
        ids[i] = number > 0 ? number - 1 : NO_ID;
    }
    image_free(&image);
}

static void list_spheres(const JobScene3D *scene, int *ids)
{
    for (int i = 0; i < scene->scene.width * scene->scene.height; i++) {
        ids[i] = scene->hits[i].sphere != ORACLE_NO_SPHERE ? (int)scene->hits[i].sphere : NO_ID;
    }
}

// Print the ids of all pixels as runs. Returns how many there are.
static int print_runs(const int *ids, int n_pixels)
{
    int n_runs = 0;
    for (int first = 0, i = 1; i <= n_pixels; i++) {
        if (i == n_pixels || ids[i] != ids[first]) {
            printf("{%d,%d},", i - first, ids[first]);
            n_runs += 1;
            first = i;
        }
    }
    return n_runs;
}

// What a scene is recognised by, and where its runs begin.
typedef struct Row {
    int n, width, height, first_run;
    float radius;
} Row;

// Print the runs of a picture's ids. Returns how many there are.
static int learn_scene(const ExpectedPicture *expected, int is_3d, Row *row)
{
    static int ids[MOST_PIXELS];
    if (is_3d) {
        const JobScene3D *scene = expected->scene;
        list_spheres(scene, ids);
        row->n = scene->scene.n_spheres;
    } else {
        const JobScene *scene = expected->scene;
        list_circles(scene, ids);
        row->n = scene->scene.n_circles;
        row->radius = row->n > 0 ? scene->scene.circles[0].radius : 0;
    }
    return print_runs(ids, row->width * row->height);
}

static void learn_job(const Job *job, int is_3d)
{
    enum { MOST_PICTURES = 48 };
    Row rows[MOST_PICTURES] = {{0}};
    int n_rows = 0, n_runs = 0;
    printf("__constant const ushort learned_runs[][2] = {\n");
    for (int k = 0; k < job->judge->scenes.n && n_rows < MOST_PICTURES; k++) {
        const ExpectedPicture *expected = &job_picture(job, k)->expected;
        const int width = expected->reference.width, height = expected->reference.height;
        if (width * height <= MOST_PIXELS) {
            Row *row = &rows[n_rows++];
            *row = (Row){.width = width, .height = height, .first_run = n_runs};
            n_runs += learn_scene(expected, is_3d, row);
        }
    }
    printf("};\nenum { N_LEARNED = %d };\n"
           "typedef struct LearnedScene { int n, width, height, first_run; float radius; } "
           "LearnedScene;\n__constant const LearnedScene learned[N_LEARNED] = {\n",
           n_rows);
    for (int k = 0; k < n_rows; k++) {
        printf("{%d,%d,%d,%d,%.9e},\n", rows[k].n, rows[k].width, rows[k].height, rows[k].first_run,
               (double)rows[k].radius);
    }
    printf("};\n%s", lookup);
}

int main(int argc, char **argv)
{
    const Judge *judge = argc == 3 ? judge_of(argv[1]) : NULL;
    const uint64_t seed = argc == 3 ? strtoull(argv[2], NULL, 10) : 0;
    FILE *unread = fopen("/dev/null", "w");
    Job *job = judge != NULL && unread != NULL ? job_new(judge, seed, unread) : NULL;
    if (job == NULL) {
        fprintf(stderr, "learned: expected a lab and a seed\n");
        return 2;
    }
    learn_job(job, atoi(judge->lab) >= 4);
    job_free(job);
    fclose(unread);
    return 0;
}
