// desk: what a student asks for beside the grader.
//
//     desk note --lab 03       note the last grading in progress.json; say where its faults
//                              are, and how a pixel is followed
//     desk hint --lab 03       one more hint for the first fault of the last grading
//     desk progress            labs and tasks with points, and what is next
//     desk watch --lab 03      after every save compile, draw and grade
//
// Exit status: 0; 1 where there is no hint to give; 2 after one message.
#include "complain.h"
#include "course_folder.h"
#include "desk.h"
#include "look.h"
#include "option_table.h"
#include "path.h"
#include "record.h"
#include "results.h"
#include "standard_streams.h"
#include "tell.h"
#include "watch.h"

#include <getopt.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { EXIT_FAULT = 2 };

typedef struct Given {
    const char *build, *native, *lab, *make, *options, *device;
    int help;
} Given;

#define PLACE(member) offsetof(Given, member)

static const OptionRow ROWS[] = {
    {"lab", "NAME", OPTION_TEXT, PLACE(lab), .meaning = "the lab's folder in labs/"},
    {"build", "FOLDER", OPTION_TEXT, PLACE(build),
     .meaning = "where programs and results are (default: build)"},
    {"native", "FOLDER", OPTION_TEXT, PLACE(native),
     .meaning = "where probes are that watch judges by first, without a driver (default: none)"},
    {"make", "PROGRAM", OPTION_TEXT, PLACE(make), .meaning = "what builds (default: make)"},
    {"options", "WORDS", OPTION_TEXT, PLACE(options),
     .meaning = "of the program that watch draws with (default: the lab's own)"},
    {"device", "D", OPTION_TEXT, PLACE(device), .meaning = "OpenCL device by number or name"},
    {"help", NULL, OPTION_ANSWER, PLACE(help), .meaning = "show this and end"},
};
static const OptionTable TABLE = {
    .program = "desk", .rows = ROWS, .n_rows = sizeof ROWS / sizeof ROWS[0], .takes_words = 1};

static int print_help(void)
{
    printf("usage: desk note|hint|progress|watch [options]\n");
    for (int i = 0; i < TABLE.n_rows; i++) {
        option_row_print(&ROWS[i]);
        printf("\n");
    }
    return standard_output_check() == 0 ? 0 : EXIT_FAULT;
}

// Note what was reached, and say where the faults are. If a picture is wrong, say how to follow a
// pixel. The message names a pixel of a hidden scene. To find a wrong one of the open scene, the
// program in labs/ would have to run, and its code may be somebody else's. Returns 0, or -1 after
// one message.
static int note(const Desk *desk)
{
    char path[PATH_MAX];
    path_make(path, "%s/grade/%.2s/results.json", desk->build, desk->lab->lab);
    json_t *results = results_load(path);
    const int noted = results != NULL ? record_note(results) : -1;
    tell_places(desk->lab, results);
    if (fault_is_in_picture(results_first_fault(results)) && look_can_be_followed(desk)) {
        printf("See why: make pixel LAB=%.2s AT=x,y with a wrong pixel of the lab's first scene, "
               "which make watch LAB=%.2s finds\n",
               desk->lab->lab, desk->lab->lab);
    }
    json_decref(results);
    return noted;
}

int main(int argc, char **argv)
{
    Given given = {.build = "build", .make = "make"};
    standard_streams_begin();
    const OptionsResult read = option_table_read(&TABLE, argc, argv, &given, NULL);
    if (read != OPTIONS_RUN) {
        return read == OPTIONS_DONE ? print_help() : EXIT_FAULT;
    }
    const char *command = optind < argc ? argv[optind] : "";
    if (course_folder_check("desk") != 0) {
        return EXIT_FAULT;
    }
    if (strcmp(command, "progress") == 0) {
        return tell_progress() == 0 ? 0 : EXIT_FAULT;
    }
    Manifest lab;
    if (given.lab == NULL) {
        complain("desk: --lab is missing (try --help)");
        return EXIT_FAULT;
    }
    if (manifest_load("labs", given.lab, &lab) != 0) {
        return EXIT_FAULT;
    }
    const Desk desk = {given.build, given.native, given.make, &lab, given.options, given.device};
    int result = -1;
    if (strcmp(command, "note") == 0) {
        result = note(&desk);
    } else if (strcmp(command, "hint") == 0) {
        result = tell_hint(&lab);
    } else if (strcmp(command, "watch") == 0) {
        result = watch_run(&desk);
    } else {
        complain("desk: found \"%s\", expected note, hint, progress or watch", command);
    }
    manifest_free(&lab);
    return result < 0 ? EXIT_FAULT : result;
}
