// grader/run_place: what a probe noted, in words of ours only.
#include "jobs.h"
#include "judge.h"
#include "manifest.h"
#include "run_place.h"
#include "surroundings.h"

#include <stdlib.h>
#include <sys/stat.h>
#include <unistd.h>

TestSuite(run_place, .timeout = 600);

static ProbeNote note_of(const char *name, uint32_t input)
{
    ProbeNote note = {.input = input};
    snprintf(note.name, sizeof note.name, "%s", name);
    return note;
}

// What the judge of a lab makes of a note's name and number.
static JobPlace place_of(const char *lab, const char *name, uint32_t number)
{
    Sections job = {0};
    FILE *file = open_memstream((char **)&job.bytes, &job.n_bytes);
    Job *made = job_new(judge_of(lab), 3, file);
    fclose(file);
    cr_assert_not_null(made);
    const JobPlace place = job_place(made, &job, name, number);
    sections_free(&job);
    job_free(made);
    return place;
}

Test(run_place, names_the_function_its_task_and_the_input)
{
    JobPlace place = place_of("02", "splits", 16);
    cr_assert_str_eq(place.step->where, "in split_box");
    cr_expect_str_eq(place.step->task, "split_box");
    cr_expect_eq(strncmp(place.with, "input 17 of 414: box x [", 24), 0, "%s", place.with);
    place = place_of("06", "todo", 9);
    cr_assert_str_eq(place.step->where, "in fits_todo");
    cr_expect_str_eq(place.with, "level 9");
}

Test(run_place, names_the_scene)
{
    JobPlace place = place_of("02", "tree", 3);
    cr_assert_str_eq(place.step->where, "while kdtree2d_build built a whole tree");
    cr_expect_null(place.step->task);
    cr_expect_eq(strncmp(place.with, "a scene like \"touching\", ", 25), 0, "%s", place.with);
    place = place_of("06", "tree", 3);
    cr_expect_str_eq(place.with, "a scene like \"planes\"");
    place = place_of("00", "arguments", 0);
    cr_expect_str_eq(place.with, "gradient, 64x48");
    place = place_of("04", "picture", 0);
    cr_expect_eq(strncmp(place.with, "directions, ", 12), 0, "%s", place.with);
    place = place_of("05", "picture", 0);
    cr_expect_neq(place.with[0], '\0');
}

Test(run_place, knows_how_many_inputs_a_kernel_has)
{
    const JobPlace place = place_of("03", "children", PROBE_NO_INPUT);
    cr_assert_str_eq(place.step->where, "in getContainingChild");
    cr_expect_eq(strncmp(place.with, "with one of ", 12), 0, "%s", place.with);
}

Test(run_place, knows_what_comes_before)
{
    ProbeNote note = note_of("", 0);
    cr_expect_str_eq(run_place_before(&note).where, "before any of your functions was called");
    note = note_of("build", 0);
    cr_expect_str_eq(run_place_before(&note).where, "while your kernels were compiled");
    note = note_of("splits", 0);
    cr_expect_str_eq(run_place_before(&note).where, "");
}

// What each lab's probe notes before it calls the function of one task.
Test(run_place, knows_every_lab)
{
    static const char *const noted[][8] = {
        {"00", "picture", "arguments", "items", "readback", NULL},
        {"01", "overlaps", NULL},
        {"02", "leaves", "splits", "overlaps", "distribute", "pack", NULL},
        {"03", "children", NULL},
        {"04", "views", NULL},
        {"05", "roots", "textbook", "projection", "normals", "shades", "hits", NULL},
        {"06", "splits", "overlaps", "pack", "todo", NULL},
        {"07", "clips", "sides", "planes", "leaves", NULL},
        {"09", "starts", "mirrors", "shadow_rays", "blocks", "lits", NULL},
        {"10", "tile_planes", "tile_children", "tile_waiting", "cones", "circle_rows",
         "tile_leaves", NULL},
    };
    for (size_t l = 0; l < sizeof noted / sizeof *noted; l++) {
        Manifest manifest;
        cr_assert_eq(manifest_load("solutions", judge_of(noted[l][0])->lab, &manifest), 0);
        for (int i = 1; noted[l][i] != NULL; i++) {
            const JobPlace place = place_of(noted[l][0], noted[l][i], 1);
            cr_assert_not_null(place.step->where, "%s: %s", manifest.lab, noted[l][i]);
            cr_assert_not_null(place.step->task, "%s: %s", manifest.lab, noted[l][i]);
            cr_expect_not_null(manifest_task(&manifest, place.step->task), "%s", place.step->task);
            cr_expect_neq(place.with[0], '\0', "%s: %s", manifest.lab, noted[l][i]);
        }
        manifest_free(&manifest);
    }
}

// The note stands where a student's code can write.
Test(run_place, takes_no_word_from_a_note)
{
    cr_expect_null(place_of("02", "the solution is", 0).step);
    cr_expect_null(place_of("02", "split", 0).step);
    cr_expect_null(place_of("02", "children", 0).step, "a step of another lab");
    ProbeNote note = note_of("splits", 0);
    cr_expect(run_note_is_name(&note));
    strcpy(note.name + 8, "hidden");
    cr_expect_not(run_note_is_name(&note), "words behind the end");
    memset(&note, 'x', sizeof note);
    cr_expect_not(run_note_is_name(&note), "no end");
    static const char *const others[] = {"", "a b", "splits:3", "splits 0\n", "%s"};
    for (size_t i = 0; i < sizeof others / sizeof *others; i++) {
        note = note_of(others[i], 0);
        cr_expect_not(run_note_is_name(&note), "\"%s\"", others[i]);
    }
}

Test(run_place, takes_no_number_that_the_job_has_not)
{
    static const uint32_t numbers[] = {414, 415, 1u << 31, UINT32_MAX};
    for (size_t i = 0; i < sizeof numbers / sizeof *numbers; i++) {
        cr_expect_str_eq(place_of("02", "splits", numbers[i]).with, "");
        cr_expect_str_eq(place_of("02", "tree", numbers[i]).with, "");
        cr_expect_str_eq(place_of("06", "todo", numbers[i]).with, "");
    }
    cr_expect_str_eq(place_of("06", "todo", 0).with, "");
}

// ---- The file -----------------------------------------------------------------------------------

static void note_save(const char *path, size_t n_bytes)
{
    const ProbeNote note[2] = {note_of("splits", 4), note_of("splits", 5)};
    FILE *file = fopen(path, "wb");
    fwrite(note, 1, n_bytes, file);
    fclose(file);
}

Test(run_place, a_note_is_a_regular_file_of_its_size, .init = folder_enter, .fini = folder_leave)
{
    note_save("note", sizeof(ProbeNote));
    cr_expect_str_eq(run_note_load("note").name, "splits");
    cr_expect_eq(run_note_load("note").input, 4);
    note_save("short", sizeof(ProbeNote) - 1);
    note_save("long", sizeof(ProbeNote) + 1);
    cr_assert_eq(symlink("note", "link") | mkfifo("fifo", 0600) | mkdir("folder", 0700), 0);
    static const char *const others[] = {"short", "long", "link", "fifo", "folder", "none"};
    for (size_t i = 0; i < sizeof others / sizeof *others; i++) {
        const ProbeNote note = run_note_load(others[i]);
        cr_expect_not(run_note_is_name(&note), "%s", others[i]);
    }
}
