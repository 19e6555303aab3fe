// judge/judge_03_alone, judge_05_alone and judge_07_alone: nothing passes alone without answers, or
// with answers of another size; and the scripted world of lab 07 has what a search must get right.
#include "job_sections.h"
#include "judge_07.h"

#include <criterion/criterion.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

TestSuite(alone_trees);

static const char *const lab_numbers[] = {"03", "05", "07"};
enum { N_LABS = sizeof lab_numbers / sizeof *lab_numbers };

// A file in memory that becomes sections.
typedef struct Writer {
    FILE *file;
    char *bytes;
    size_t n_bytes;
} Writer;

static void writer_open(Writer *writer)
{
    *writer = (Writer){0};
    writer->file = open_memstream(&writer->bytes, &writer->n_bytes);
    cr_assert_not_null(writer->file);
}

static Sections writer_close(Writer *writer)
{
    cr_assert_eq(fclose(writer->file), 0);
    return (Sections){(unsigned char *)writer->bytes, writer->n_bytes};
}

static void *job_open(const Judge *judge)
{
    Writer writer;
    writer_open(&writer);
    Job *job = job_new(judge, 1, writer.file);
    Sections whole = writer_close(&writer);
    sections_free(&whole);
    cr_assert_not_null(job);
    return job;
}

static void expect_none_passes(const Judge *judge, const void *job, const Sections *answers)
{
    for (int i = 0; i < judge->n_checks; i++) {
        cr_expect_eq(job_passes_alone(job, i, answers), 0, "%s", judge->checks[i].id);
    }
}

Test(alone_trees, without_answers_nothing_passes)
{
    for (int lab = 0; lab < N_LABS; lab++) {
        const Judge *judge = judge_of(lab_numbers[lab]);
        Job *job = job_open(judge);
        const Sections none = {0};
        expect_none_passes(judge, job, &none);
        job_free(job);
    }
}

Test(alone_trees, answers_of_another_size_do_not_pass)
{
    static const char *const stems[] = {"children", "roots",  "textbook",     "projection",
                                        "normals",  "shades", "pixel_shades", "clips",
                                        "sides",    "planes", "leaves"};
    static const char *const numbered[] = {"picture", "hits", "work"};
    const float few[4] = {0};
    for (int lab = 0; lab < N_LABS; lab++) {
        const Judge *judge = judge_of(lab_numbers[lab]);
        Job *job = job_open(judge);
        Writer writer;
        writer_open(&writer);
        for (size_t i = 0; i < sizeof stems / sizeof *stems; i++) {
            section_write(writer.file, stems[i], few, sizeof few);
        }
        for (int i = 0; i < 3 * 40; i++) {
            char name[SECTION_NAME_BYTES];
            snprintf(name, sizeof name, "%s.%d", numbered[i % 3], i / 3);
            section_write(writer.file, name, few, sizeof few);
        }
        Sections answers = writer_close(&writer);
        expect_none_passes(judge, job, &answers);
        sections_free(&answers);
        job_free(job);
    }
}

Test(alone_trees, an_alone_job_that_cannot_be_written_is_none)
{
    for (int lab = 0; lab < N_LABS; lab++) {
        const Judge *judge = judge_of(lab_numbers[lab]);
        Job *job = job_open(judge);
        for (int i = 0; i < judge->n_checks; i++) {
            FILE *full = fopen("/dev/full", "wb");
            cr_assert_not_null(full);
            cr_expect_neq(job_write_alone(job, judge->checks[i].task, full), 0, "%s",
                          judge->checks[i].task);
            fclose(full);
        }
        job_free(job);
    }
}

// ---- The scripted world -------------------------------------------------------------------------

static int n_pixels(const JobScene3D *scene)
{
    return scene->scene.width * scene->scene.height;
}

static ScriptedSearch search(const JobScene3D *scene, int pixel)
{
    return scripted_07_search(scene, pixel % scene->scene.width, pixel / scene->scene.width);
}

Test(alone_trees, the_scripted_world_has_all_kinds_of_rays)
{
    Job07 *job = job_open(judge_of("07"));
    int n_hits = 0, n_misses = 0, n_many_leaves = 0;
    u32 deepest = 0;
    for (int k = 0; k < N_SCRIPTED; k++) {
        for (int pixel = 0; pixel < n_pixels(&job->scripted[k]); pixel++) {
            const ScriptedSearch found = search(&job->scripted[k], pixel);
            n_hits += found.sphere != ORACLE_NO_SPHERE;
            n_misses += found.sphere == ORACLE_NO_SPHERE;
            n_many_leaves += found.work.n_leaves_visited > 2;
            deepest = found.work.stack_depth > deepest ? found.work.stack_depth : deepest;
        }
    }
    cr_expect_gt(n_hits, 4000);
    cr_expect_gt(n_misses, 3000);
    cr_expect_gt(n_many_leaves, 4000);
    cr_expect_eq(deepest, TODO_SIZE);
    job_free(&job->job);
}

// Most pixels' colours are certain: else pictures would say little.
Test(alone_trees, few_scripted_colours_are_ambiguous)
{
    Job07 *job = job_open(judge_of("07"));
    for (int k = 0; k < N_SCRIPTED; k++) {
        const JobScene3D *scene = &job->scripted[k];
        int n_vague = 0;
        for (int pixel = 0; pixel < n_pixels(scene); pixel++) {
            n_vague += !(scene->picture.expected.tolerances[pixel] < 1e-3f);
        }
        cr_expect_lt(n_vague, n_pixels(scene) / 50, "%s", scene->picture.title);
    }
    job_free(&job->job);
}

// Write what a right search gives, but for one pixel of one scene.
static Sections scripted_answers(const Job07 *job, int wrong_scene, int wrong_pixel)
{
    Writer writer;
    writer_open(&writer);
    for (int k = 0; k < N_SCRIPTED; k++) {
        const JobScene3D *scene = &job->scripted[k];
        const size_t side = PROBE_IMAGE_SIDE(scene->scene.width);
        const size_t n_work = side * (size_t)PROBE_IMAGE_SIDE(scene->scene.height);
        HitAnswer *hits = calloc((size_t)n_pixels(scene), sizeof *hits);
        Work *work = calloc(n_work, sizeof *work);
        cr_assert(hits != NULL && work != NULL);
        for (int pixel = 0; pixel < n_pixels(scene); pixel++) {
            const ScriptedSearch found = search(scene, pixel);
            hits[pixel] = (HitAnswer){found.t, found.sphere};
            work[pixel] = found.work;
            if (k == wrong_scene && pixel == wrong_pixel) {
                hits[pixel].sphere ^= 1;
                work[pixel].n_nodes_visited++;
            }
        }
        char name[SECTION_NAME_BYTES];
        snprintf(name, sizeof name, "hits.%d", k);
        section_write(writer.file, name, hits, (size_t)n_pixels(scene) * sizeof *hits);
        snprintf(name, sizeof name, "work.%d", k);
        section_write(writer.file, name, work, n_work * sizeof *work);
        free(hits);
        free(work);
    }
    return writer_close(&writer);
}

// Does a check of lab 07's pass alone?
static int passes(const Job07 *job, const char *id, const Sections *answers)
{
    int i = 0;
    while (strcmp(job->job.judge->checks[i].id, id) != 0) {
        i++;
    }
    return job_passes_alone(&job->job, i, answers);
}

Test(alone_trees, one_wrong_ray_fails)
{
    const Judge *judge = judge_of("07");
    Job07 *job = job_open(judge);
    Sections all_right = scripted_answers(job, -1, 0);
    Sections one_wrong = scripted_answers(job, SCRIPTED_EDGES, 700);
    cr_expect(passes(job, "trace-random", &all_right));
    cr_expect(passes(job, "trace-edges", &all_right));
    cr_expect(passes(job, "trace-early-end", &all_right));
    cr_expect_not(passes(job, "trace-picture", &all_right));
    cr_expect(passes(job, "trace-random", &one_wrong));
    cr_expect_not(passes(job, "trace-edges", &one_wrong));
    cr_expect_not(passes(job, "trace-early-end", &one_wrong));
    sections_free(&all_right);
    sections_free(&one_wrong);
    job_free(&job->job);
}
