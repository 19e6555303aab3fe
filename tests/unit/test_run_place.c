// grader/run_place: what a probe noted, in words of ours only.
#include "jobs.h"
#include "judge.h"
#include "manifest.h"
#include "run_place.h"
#include "surroundings.h"

#include <errno.h>
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

// A lab's job, and as it is written.
typedef struct MadeJob {
    Job *job;
    Sections written;
} MadeJob;

static MadeJob job_make(const char *lab)
{
    MadeJob made = {0};
    FILE *file = open_memstream((char **)&made.written.bytes, &made.written.n_bytes);
    made.job = job_new(judge_of(lab), 3, file);
    fclose(file);
    cr_assert_not_null(made.job);
    return made;
}

static void job_forget(MadeJob *made)
{
    sections_free(&made->written);
    job_free(made->job);
}

// What the judge of a lab makes of a note's name and number.
static JobPlace place_of(const char *lab, const char *name, uint32_t number)
{
    MadeJob made = job_make(lab);
    const JobPlace place = job_place(made.job, &made.written, name, number);
    job_forget(&made);
    return place;
}

Test(run_place, names_the_function_its_task_and_the_input)
{
    JobPlace place = place_of("02", "splits", 16);
    cr_assert_str_eq(place.where, "in split_box");
    cr_expect_str_eq(place.task, "split_box");
    cr_expect_eq(strncmp(place.with, "input 17 of 414: box x [", 24), 0, "%s", place.with);
    place = place_of("06", "todo", 8);
    cr_assert_str_eq(place.where, "in fits_todo");
    cr_expect_eq(strncmp(place.with, "input 9 of ", 11), 0, "%s", place.with);
    cr_expect_not_null(strstr(place.with, ": level 9"), "%s", place.with);
}

// On the device, too: by the words of a check's message.
Test(run_place, names_the_input_on_the_device)
{
    for (int l = 0; judges[l] != NULL; l++) {
        MadeJob made = job_make(judges[l]->lab);
        for (int i = 0; i < judges[l]->n_parts; i++) {
            const JobPart *part = &judges[l]->parts[i];
            const JobPlace place = job_place(made.job, &made.written, part->section, 1);
            if (part->input_bytes > 0) {
                cr_expect_eq(strncmp(place.with, "input 2 of ", 11), 0, "%s: %s", part->section,
                             place.with);
                cr_expect_not_null(strchr(place.with, ':'), "%s: %s", part->section, place.with);
            }
        }
        job_forget(&made);
    }
}

// Of a stack on which nothing waits, nothing can be taken.
Test(run_place, says_what_a_crash_with_an_empty_stack_comes_from)
{
    int n_empty = 0;
    MadeJob made = job_make("07"), tiles = job_make("10");
    for (uint32_t i = 0; i < 30; i++) {
        JobPlace place = job_place(made.job, &made.written, "next_waiting", i);
        const int is_empty = strstr(place.with, "and 0 nodes are waiting") != NULL;
        cr_expect_eq(place.suspect != NULL, is_empty, "%s", place.with);
        n_empty += is_empty;
        place = job_place(tiles.job, &tiles.written, "tile_waiting", i);
        cr_expect(place.suspect != NULL || strstr(place.with, "nothing waiting") == NULL, "%s",
                  place.with);
    }
    cr_expect_gt(n_empty, 0);
    cr_expect_lt(n_empty, 30);
    cr_expect_null(job_place(made.job, &made.written, "next_child", 0).suspect);
    job_forget(&made);
    job_forget(&tiles);
}

Test(run_place, names_the_scene)
{
    JobPlace place = place_of("02", "tree", 3);
    cr_assert_str_eq(place.where, "while kdtree2d_build built a whole tree");
    cr_expect_null(place.task);
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
    cr_assert_str_eq(place.where, "in getContainingChild");
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
            cr_assert_neq(place.where[0], '\0', "%s: %s", manifest.lab, noted[l][i]);
            cr_assert_not_null(place.task, "%s: %s", manifest.lab, noted[l][i]);
            cr_expect_not_null(manifest_task(&manifest, place.task), "%s", place.task);
            cr_expect_neq(place.with[0], '\0', "%s: %s", manifest.lab, noted[l][i]);
        }
        manifest_free(&manifest);
    }
}

// The note stands where a student's code can write.
Test(run_place, takes_no_word_from_a_note)
{
    cr_expect_str_eq(place_of("02", "the solution is", 0).where, "");
    cr_expect_str_eq(place_of("02", "split", 0).where, "");
    cr_expect_str_eq(place_of("02", "children", 0).where, "", "a step of another lab");
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
    }
}

// ---- The file -----------------------------------------------------------------------------------

// What a probe leaves in a folder of this name.
static void note_save(const char *folder, ProbeNote note, size_t n_bytes)
{
    const ProbeNote notes[2] = {note, note_of("splits", 5)};
    char path[64];
    cr_assert(mkdir(folder, 0700) == 0 || errno == EEXIST);
    snprintf(path, sizeof path, "%s/note", folder);
    file_write(path, (const char *)notes, n_bytes);
}

Test(run_place, a_note_is_a_regular_file_of_its_size, .init = folder_enter, .fini = folder_leave)
{
    const ProbeNote note = note_of("splits", 4);
    note_save("out", note, sizeof note);
    cr_expect_str_eq(run_note_load("out").name, "splits");
    cr_expect_eq(run_note_load("out").input, 4);
    note_save("short", note, sizeof note - 1);
    note_save("long", note, sizeof note + 1);
    cr_assert_eq(mkdir("linked", 0700) | symlink("../out/note", "linked/note"), 0);
    cr_assert_eq(mkdir("piped", 0700) | mkfifo("piped/note", 0600), 0);
    cr_assert_eq(mkdir("deep", 0700) | mkdir("deep/note", 0700), 0);
    static const char *const others[] = {"short", "long", "linked", "piped", "deep", "none"};
    for (size_t i = 0; i < sizeof others / sizeof *others; i++) {
        const ProbeNote other = run_note_load(others[i]);
        cr_expect_not(run_note_is_name(&other), "%s", others[i]);
    }
}

// Of 5 answers of 4 bytes, the first n of which are there.
static uint32_t input_after(int n, uint32_t n_together)
{
    ProbeNote note = note_of("splits", PROBE_NO_INPUT);
    uint32_t answers[5];
    memset(answers, 0xff, sizeof answers);
    for (int i = 0; i < n; i++) {
        answers[i] = i == 1 ? UINT32_MAX : 0xffffff00;
    }
    note.n_together = n_together;
    note_save("out", note, sizeof note);
    file_write("out/answering", (const char *)answers, sizeof answers);
    return run_note_load("out").input;
}

Test(run_place, of_inputs_tried_together_it_is_the_one_behind_the_last_answer, .init = folder_enter,
     .fini = folder_leave)
{
    cr_expect_eq(input_after(0, 5), 0);
    cr_expect_eq(input_after(1, 5), 1);
    cr_expect_eq(input_after(3, 5), 3, "though the second answer has every bit set");
    cr_expect_eq(input_after(5, 5), PROBE_NO_INPUT, "all are answered");
    cr_expect_eq(input_after(3, 0), PROBE_NO_INPUT, "they are not tried together");
    cr_expect_eq(input_after(3, 3), PROBE_NO_INPUT, "that is no whole number of bytes");
    cr_expect_eq(input_after(3, UINT32_MAX), PROBE_NO_INPUT);
    cr_assert_eq(remove("out/answering"), 0);
    cr_expect_eq(run_note_load("out").input, PROBE_NO_INPUT);
}
