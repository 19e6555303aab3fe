// judge_03_alone, judge_05_alone, judge_07_alone, judge_09_alone and judge_10: nothing passes alone
// without answers, or with answers of another size.
#include "judge.h"
#include "right_answers_sections.h"

TestSuite(alone_trees);

static const char *const lab_numbers[] = {"03", "05", "07", "09", "10"};
enum { N_LABS = sizeof lab_numbers / sizeof *lab_numbers };

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
    static const char *const stems[] = {
        "children",     "roots",        "textbook",     "projection",  "normals",
        "shades",       "pixel_shades", "clips",        "sides",       "planes",
        "leaves",       "next_child",   "next_waiting", "starts",      "mirrors",
        "shadow_rays",  "blocks",       "lits",         "tile_planes", "tile_children",
        "tile_waiting", "cones",        "circle_rows",  "tile_leaves", "circle_tiles"};
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
