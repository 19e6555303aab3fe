// The command line (see options.h).
//
// Flow: SCENE -> buffers -> kernel -> image -> comparison: what the user wants, before all else.
// One table holds every option; reading, refusing and --help all follow it.
// Read next: lab.c, which calls it.
#include "options.h"

#include "cl_setup.h"
#include "complain.h"
#include "course_folder.h"
#include "image.h"
#include "number.h"
#include "output_place.h"
#include "scene2d.h"
#include "scene3d.h"
#include "standard_streams.h"

#include <errno.h>
#include <getopt.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>

// A picture's side at most: pixel coordinates stay exact in float, with 1/16 px to spare.
#define LARGEST_SIDE 1000000
#define LARGEST_COUNT 1000000000

// What getopt_long() returns for the first row of the table: beyond every letter, as those stand
// for faults.
#define FIRST_ROW 256

enum OptionId {
    SCENE,
    SIZE,
    OUTPUT,
    FRAMES,
    STATS,
    DEVICE,
    MAX_DEPTH,
    LEAF_SIZE,
    HEAT_MAP,
    TEXTBOOK,
    PATH,
    RECORD,
    MOVIE,
    SCRIPT,
    LIST_DEVICES,
    HELP
};

static const struct OptionRow {
    const char *name;
    const char *argument;  // what --help calls it, NULL when there is none
    int set;               // the OPTIONS_... it belongs to, 0: used by every lab
    const char *meaning;
} ROWS[] = {
    [SCENE] = {"scene", "NAME", OPTIONS_SCENE | OPTIONS_SCENE3D, "a file or a generator"},
    [SIZE] = {"size", "WxH", 0, "the picture's size in pixels"},
    [OUTPUT] = {"output", "FILE", 0, "the picture, .png or .exr"},
    [FRAMES] = {"frames", "N", 0, "draw N times, for measuring (1)"},
    [STATS] = {"stats", "FILE", 0, "write the figures as JSON"},
    [DEVICE] = {"device", "D", OPTIONS_DEVICE,
                "number or part of a name ($" CL_DEVICE_VARIABLE ", or the first)"},
    [MAX_DEPTH] = {"max-depth", "N", OPTIONS_TREE, "levels of the tree, the root's included"},
    [LEAF_SIZE] = {"leaf-size", "N", OPTIONS_TREE, "elements at which a node stays a leaf"},
    [HEAT_MAP] = {"heat-map", NULL, OPTIONS_WORK, "save each pixel's work beside the picture"},
    [TEXTBOOK] = {"textbook", NULL, OPTIONS_TEXTBOOK, "intersect by the textbook's quadratic"},
    [PATH] = {"path", "FILE", OPTIONS_VIEW, "fly this path, as --record writes it"},
    [RECORD] = {"record", "FILE", OPTIONS_VIEW, "write down the path that is flown"},
    [MOVIE] = {"movie", "FOLDER", OPTIONS_VIEW, "no window: draw --path as pictures"},
    [SCRIPT] = {"script", "FILE", OPTIONS_VIEW, "keys and mouse events from a file"},
    [LIST_DEVICES] = {"list-devices", NULL, 0, "show the devices and end"},
    [HELP] = {"help", NULL, 0, "show this and end"},
};
#define N_ROWS ((int)(sizeof ROWS / sizeof ROWS[0]))

// The default of --output; an Options points to it.
static char default_output[256];

static int row_is_used(const struct OptionRow *row, int set)
{
    return row->set == 0 || (row->set & set) != 0;
}

// Complain about an argument. Returns OPTIONS_BAD.
static OptionsResult refuse(const char *lab_name, const char *option, const char *found,
                            const char *expected)
{
    complain("%s: --%s: found \"%s\", expected %s (try --help)", lab_name, option, found, expected);
    return OPTIONS_BAD;
}

static const char *default_scene(int set)
{
    return set & OPTIONS_SCENE3D ? "sphereflake" : "random";
}

static void print_scenes(const char *list, const char *edge_case(int index))
{
    printf("\nScenes: %s", list);
    for (int i = 0; edge_case(i) != NULL; i++) {
        printf(", %s", edge_case(i));
    }
    printf("\n");
}

static void print_default_size(int set)
{
    if (set & (OPTIONS_SCENE | OPTIONS_SCENE3D)) {
        printf(" (the scene's own)");
    } else {
        printf(" (%dx%d)", OPTIONS_DEFAULT_WIDTH, OPTIONS_DEFAULT_HEIGHT);
    }
}

static void print_help(const char *lab_name, const char *what, int set)
{
    printf("%s: %s\n\nOptions (and what holds without them):\n", lab_name, what);
    for (int id = 0; id < N_ROWS; id++) {
        const struct OptionRow *row = &ROWS[id];
        if (!row_is_used(row, set)) {
            continue;
        }
        char option[32];
        snprintf(option, sizeof option, "--%s %s", row->name, row->argument ? row->argument : "");
        printf("  %-16s  %s", option, row->meaning);
        if (id == OUTPUT) {
            printf(" (%s)", default_output);
        }
        if (id == SCENE) {
            printf(" (%s)", default_scene(set));
        }
        if (id == SIZE) {
            print_default_size(set);
        }
        if (set & OPTIONS_SCENE3D && (id == MAX_DEPTH || id == LEAF_SIZE)) {
            printf(" (fits the scene)");
        } else if (id == MAX_DEPTH) {
            printf(" (%d)", OPTIONS_DEFAULT_MAX_DEPTH);
        } else if (id == LEAF_SIZE) {
            printf(" (%d)", OPTIONS_DEFAULT_LEAF_SIZE);
        }
        printf("\n");
    }
    printf("Options of other labs are taken, too, and not used.\n");
    if (set & OPTIONS_SCENE) {
        print_scenes(SCENE2D_NAMES, scene2d_edge_case);
    }
    if (set & OPTIONS_SCENE3D) {
        print_scenes(SCENE3D_NAMES, scene3d_edge_case);
    }
}

// "640x480". Returns 0, or -1.
static int read_size(const char *text, int *width, int *height)
{
    char columns[16];
    const char *cross = strchr(text, 'x');
    if (cross == NULL || (size_t)(cross - text) >= sizeof columns) {
        return -1;
    }
    memcpy(columns, text, (size_t)(cross - text));
    columns[cross - text] = '\0';

    int64_t w, h;
    if (number_read_integer(columns, 1, LARGEST_SIDE, &w) != 0 ||
        number_read_integer(cross + 1, 1, LARGEST_SIDE, &h) != 0) {
        return -1;
    }
    *width = (int)w;
    *height = (int)h;
    return 0;
}

static int read_count(const char *text, int highest, int *count)
{
    int64_t number;
    if (number_read_integer(text, 1, highest, &number) != 0) {
        return -1;
    }
    *count = (int)number;
    return 0;
}

// Take one option in. Returns OPTIONS_RUN, or OPTIONS_BAD after one message.
static OptionsResult read_option(const char *lab_name, enum OptionId id, const char *text,
                                 Options *options)
{
    const char *expected = NULL;  // set when the text is not that
    switch (id) {
    case SCENE:
        options->scene = text;
        break;
    case OUTPUT:
        options->output = text;
        break;
    case STATS:
        options->stats = text;
        break;
    case DEVICE:
        options->device = text;
        break;
    case SIZE:
        if (read_size(text, &options->width, &options->height) != 0) {
            expected = "WxH, two whole numbers from 1 to " NUMBER_TEXT(LARGEST_SIDE);
        }
        break;
    case FRAMES:
        if (read_count(text, LARGEST_COUNT, &options->n_frames) != 0) {
            expected = "a whole number of at least 1";
        }
        break;
    case MAX_DEPTH:
        if (read_count(text, OPTIONS_LARGEST_MAX_DEPTH, &options->max_depth) != 0) {
            expected = "a whole number from 1 to " NUMBER_TEXT(OPTIONS_LARGEST_MAX_DEPTH);
        }
        break;
    case LEAF_SIZE:
        if (read_count(text, LARGEST_COUNT, &options->leaf_size) != 0) {
            expected = "a whole number of at least 1";
        }
        break;
    case HEAT_MAP:
        options->heat_map = 1;
        break;
    case TEXTBOOK:
        options->textbook = 1;
        break;
    case PATH:
        options->path = text;
        break;
    case RECORD:
        options->record = text;
        break;
    case MOVIE:
        options->movie = text;
        break;
    case SCRIPT:
        options->script = text;
        break;
    case LIST_DEVICES:
    case HELP:
        break;
    }
    return expected == NULL ? OPTIONS_RUN : refuse(lab_name, ROWS[id].name, text, expected);
}

// Can the file be made?
static OptionsResult check_place(const char *lab_name, const char *option, const char *path)
{
    const char *expected = output_place_fault(path);
    return expected == NULL ? OPTIONS_RUN : refuse(lab_name, option, path, expected);
}

static OptionsResult check_stats(const char *lab_name, const Options *options)
{
    if (output_place_is_same(options->stats, options->output)) {
        return refuse(lab_name, "stats", options->stats, "another file than --output");
    }
    return check_place(lab_name, "stats", options->stats);
}

static OptionsResult check_output(const char *lab_name, const char *path)
{
    if (path == default_output && mkdir("build", 0777) != 0 && errno != EEXIST) {
        complain("%s: cannot make the folder build: %s", lab_name, strerror(errno));
        return OPTIONS_BAD;
    }
    if (image_stem_length(path) == 0) {
        return refuse(lab_name, "output", path, "a file that ends in .png or .exr");
    }
    return check_place(lab_name, "output", path);
}

// How many options begin with the word "--s" or "--s=1"?
static int count_meant(const char *word)
{
    int n_meant = 0;
    for (int id = 0; id < N_ROWS; id++) {
        n_meant += strncmp(ROWS[id].name, word + 2, strcspn(word + 2, "=")) == 0;
    }
    return n_meant;
}

// What getopt_long() could not take.
//   fault   its answer: ':' for an argument that is missing, '?' for all else
//   about   its optopt: FIRST_ROW or more is an option that exists, 0 a word with --, else a letter
static OptionsResult report_fault(const char *lab_name, int fault, int about, const char *word)
{
    if (about >= FIRST_ROW) {
        complain("%s: --%s %s an argument (try --help)", lab_name, ROWS[about - FIRST_ROW].name,
                 fault == ':' ? "needs" : "does not take");
    } else if (about != 0) {
        complain("%s: -%c is no option here (try --help)", lab_name, about);
    } else {
        complain("%s: %s is %s (try --help)", lab_name, word,
                 count_meant(word) > 1 ? "short for more than one option" : "no option here");
    }
    return OPTIONS_BAD;
}

// Say which of the options given are of no use here; is_given[id] for each row of the table.
static void note_unused(const char *lab_name, int set, const int is_given[N_ROWS])
{
    for (int id = 0; id < N_ROWS; id++) {
        if (is_given[id] && !row_is_used(&ROWS[id], set)) {
            complain("%s: --%s is not used in this lab", lab_name, ROWS[id].name);
        }
    }
}

// Go through the words and mark in is_given[] what was there. Returns as options_parse() does.
static OptionsResult read_words(int argc, char **argv, const char *lab_name, const char *what,
                                int set, Options *options, int is_given[N_ROWS])
{
    struct option known[N_ROWS + 1];
    for (int id = 0; id < N_ROWS; id++) {
        int has_argument = ROWS[id].argument != NULL ? required_argument : no_argument;
        known[id] = (struct option){ROWS[id].name, has_argument, NULL, FIRST_ROW + id};
    }
    known[N_ROWS] = (struct option){NULL, 0, NULL, 0};

    optind = 0;  // start afresh, for callers that read more than one command line
    int answer;
    // ":" asks for silence on faults and for ':' where an argument is missing.
    while ((answer = getopt_long(argc, argv, ":", known, NULL)) != -1) {
        if (answer < FIRST_ROW) {
            return report_fault(lab_name, answer, optopt, argv[optind - 1]);
        }
        int id = answer - FIRST_ROW;
        if (id == HELP) {
            print_help(lab_name, what, set);
            return standard_output_check() == 0 ? OPTIONS_DONE : OPTIONS_BAD;
        }
        if (id == LIST_DEVICES) {
            const int is_listed = cl_setup_list(stdout) == 0 && standard_output_check() == 0;
            return is_listed ? OPTIONS_DONE : OPTIONS_BAD;
        }
        if (read_option(lab_name, (enum OptionId)id, optarg, options) != OPTIONS_RUN) {
            return OPTIONS_BAD;
        }
        is_given[id] = 1;
    }
    if (optind < argc) {
        complain("%s: found the stray word \"%s\" (try --help)", lab_name, argv[optind]);
        return OPTIONS_BAD;
    }
    return OPTIONS_RUN;
}

OptionsResult options_parse(int argc, char **argv, const char *lab_name, const char *what, int set,
                            Options *options)
{
    standard_streams_begin();
    snprintf(default_output, sizeof default_output, "build/%s.png", lab_name);
    *options = (Options){
        .scene = default_scene(set),
        .output = default_output,
        .n_frames = 1,
        .max_depth = set & OPTIONS_SCENE3D ? 0 : OPTIONS_DEFAULT_MAX_DEPTH,
        .leaf_size = set & OPTIONS_SCENE3D ? 0 : OPTIONS_DEFAULT_LEAF_SIZE,
    };
    int is_given[N_ROWS] = {0};
    OptionsResult result = read_words(argc, argv, lab_name, what, set, options, is_given);
    if (result == OPTIONS_RUN) {
        result = course_folder_check(lab_name) == 0 ? OPTIONS_RUN : OPTIONS_BAD;
    }
    if (result == OPTIONS_RUN) {
        result = check_output(lab_name, options->output);
    }
    if (result == OPTIONS_RUN && options->stats != NULL) {
        result = check_stats(lab_name, options);
    }
    if (result == OPTIONS_RUN && options->record != NULL) {
        result = check_place(lab_name, "record", options->record);
    }
    // Last, so that a fault is told alone.
    if (result == OPTIONS_RUN) {
        note_unused(lab_name, set, is_given);
    }
    return result;
}
