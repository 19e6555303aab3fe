// The command line (see options.h).
//
// One table holds every option; reading, refusing and --help all follow it (option_table.h). Read
// next: lab.c, which calls it.
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
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>

// A picture's side at most: pixel coordinates stay exact in float, with 1/16 px to spare.
#define LARGEST_SIDE 1000000

// Rows whose default the help tells.
enum { SCENE, SIZE, OUTPUT, MAX_DEPTH, LEAF_SIZE };

#define PLACE(member) offsetof(Options, member)

static const OptionRow ROWS[] = {
    [SCENE] = {"scene", "NAME", OPTION_TEXT, PLACE(scene), .set = OPTIONS_SCENE | OPTIONS_SCENE3D,
               .meaning = "a file or a generator"},
    [SIZE] = {"size", "WxH", OPTION_SIZE, PLACE(width), 1, LARGEST_SIDE,
              .meaning = "the picture's size in pixels"},
    [OUTPUT] = {"output", "FILE", OPTION_TEXT, PLACE(output),
                .meaning = "the picture, .png or .exr"},
    [MAX_DEPTH] = {"max-depth", "N", OPTION_NUMBER, PLACE(max_depth), 1, OPTIONS_LARGEST_MAX_DEPTH,
                   OPTIONS_TREE, "levels of the tree, the root's included"},
    [LEAF_SIZE] = {"leaf-size", "N", OPTION_NUMBER, PLACE(leaf_size), 1, OPTION_LARGEST_NUMBER,
                   OPTIONS_TREE, "elements at which a node stays a leaf"},
    {"frames", "N", OPTION_NUMBER, PLACE(n_frames), 1, OPTION_LARGEST_NUMBER,
     .meaning = "draw N times, for measuring (1)"},
    {"stats", "FILE", OPTION_TEXT, PLACE(stats), .meaning = "write the figures as JSON"},
    {"device", "D", OPTION_TEXT, PLACE(device), .set = OPTIONS_DEVICE,
     .meaning = "number or part of a name ($" CL_DEVICE_VARIABLE ", or the first)"},
    {"heat-map", NULL, OPTION_FLAG, PLACE(heat_map), .set = OPTIONS_WORK,
     .meaning = "save each pixel's work beside the picture"},
    {"textbook", NULL, OPTION_FLAG, PLACE(textbook), .set = OPTIONS_TEXTBOOK,
     .meaning = "intersect by the textbook's quadratic"},
    {"bounces", "N", OPTION_NUMBER, PLACE(n_bounces), 0, OPTIONS_MOST_BOUNCES,
     OPTIONS_MIRRORS | OPTIONS_SHADOWS,
     "a ray is mirrored at most N times (" NUMBER_TEXT(OPTIONS_DEFAULT_BOUNCES) ")"},
    {"acne", NULL, OPTION_FLAG, PLACE(acne), .set = OPTIONS_MIRRORS,
     .meaning = "let new rays start on the surface, not off it"},
    {"circles", NULL, OPTION_FLAG, PLACE(circles), .set = OPTIONS_CIRCLES,
     .meaning = "draw circles; --scene is then one of them"},
    {"shadows", NULL, OPTION_FLAG, PLACE(shadows), .set = OPTIONS_SHADOWS,
     .meaning = "shadows and mirrors, as in lab 09"},
    {"path", "FILE", OPTION_TEXT, PLACE(path), .set = OPTIONS_VIEW,
     .meaning = "fly this path, as --record writes it"},
    {"record", "FILE", OPTION_TEXT, PLACE(record), .set = OPTIONS_VIEW,
     .meaning = "write down the path that is flown"},
    {"movie", "FOLDER", OPTION_TEXT, PLACE(movie), .set = OPTIONS_VIEW,
     .meaning = "no window: draw --path as pictures"},
    {"script", "FILE", OPTION_TEXT, PLACE(script), .set = OPTIONS_VIEW,
     .meaning = "keys and mouse events from a file"},
    {"pixel", "X,Y", OPTION_POINT, PLACE(pixel_x), 0, LARGEST_SIDE, .set = OPTIONS_PIXEL,
     .meaning = "the pixel to follow; 0,0 is the top left one"},
    {"json", "FILE", OPTION_TEXT, PLACE(json), .set = OPTIONS_PIXEL,
     .meaning = "write its steps as JSON"},
    {"svg", "FILE", OPTION_TEXT, PLACE(svg), .set = OPTIONS_PIXEL, .meaning = "draw its steps"},
    {"list-devices", NULL, OPTION_ANSWER, PLACE(list_devices),
     .meaning = "show the devices and end"},
    {"help", NULL, OPTION_ANSWER, PLACE(help), .meaning = "show this and end"},
};
#define N_ROWS ((int)(sizeof ROWS / sizeof ROWS[0]))

// The default of --output; an Options points to it.
static char default_output[256];

static int row_is_used(const OptionRow *row, int set)
{
    return row->set == 0 || (row->set & set) != 0;
}

static const char *default_scene(int set)
{
    return set & OPTIONS_SCENE3D ? "sphereflake" : "random";
}

static void print_scenes(const char *title, const char *list, const char *edge_case(int index))
{
    printf("\n%s: %s", title, list);
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
        if (!row_is_used(&ROWS[id], set)) {
            continue;
        }
        option_row_print(&ROWS[id]);
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
        print_scenes("Scenes", SCENE2D_NAMES, scene2d_edge_case);
    }
    if (set & OPTIONS_SCENE3D) {
        print_scenes("Scenes", SCENE3D_NAMES, scene3d_edge_case);
    }
    if (set & OPTIONS_CIRCLES) {
        print_scenes("Scenes with --circles", SCENE2D_NAMES, scene2d_edge_case);
    }
}

// Can the file be made?
static OptionsResult check_place(const OptionTable *table, const char *option, const char *path)
{
    const char *expected = output_place_fault(path);
    return expected == NULL ? OPTIONS_RUN : option_table_refuse(table, option, path, expected);
}

static OptionsResult check_stats(const OptionTable *table, const Options *options)
{
    if (output_place_is_same(options->stats, options->output)) {
        return option_table_refuse(table, "stats", options->stats, "another file than --output");
    }
    return check_place(table, "stats", options->stats);
}

static OptionsResult check_output(const OptionTable *table, const char *path)
{
    if (path == default_output && mkdir("build", 0777) != 0 && errno != EEXIST) {
        complain("%s: cannot make the folder build: %s", table->program, strerror(errno));
        return OPTIONS_BAD;
    }
    if (image_stem_length(path) == 0) {
        return option_table_refuse(table, "output", path, "a file that ends in .png or .exr");
    }
    return check_place(table, "output", path);
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

// Answer --help or --list-devices.
static OptionsResult answer(const char *lab_name, const char *what, int set, const Options *options)
{
    if (options->help) {
        print_help(lab_name, what, set);
    } else if (cl_setup_list(stdout) != 0) {
        return OPTIONS_BAD;
    }
    return standard_output_check() == 0 ? OPTIONS_DONE : OPTIONS_BAD;
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
        .pixel_x = -1,
        .pixel_y = -1,
        .n_bounces = OPTIONS_DEFAULT_BOUNCES,
        .max_depth = set & OPTIONS_SCENE3D ? 0 : OPTIONS_DEFAULT_MAX_DEPTH,
        .leaf_size = set & OPTIONS_SCENE3D ? 0 : OPTIONS_DEFAULT_LEAF_SIZE,
    };
    const OptionTable table = {.program = lab_name, .rows = ROWS, .n_rows = N_ROWS};
    int is_given[N_ROWS];
    OptionsResult result = option_table_read(&table, argc, argv, options, is_given);
    if (result == OPTIONS_DONE) {
        return answer(lab_name, what, set, options);
    }
    if (set & OPTIONS_CIRCLES && options->circles && !is_given[SCENE]) {
        options->scene = default_scene(OPTIONS_SCENE);
    }
    if (result == OPTIONS_RUN) {
        result = course_folder_check(lab_name) == 0 ? OPTIONS_RUN : OPTIONS_BAD;
    }
    if (result == OPTIONS_RUN) {
        result = check_output(&table, options->output);
    }
    if (result == OPTIONS_RUN && options->stats != NULL) {
        result = check_stats(&table, options);
    }
    if (result == OPTIONS_RUN && options->record != NULL) {
        result = check_place(&table, "record", options->record);
    }
    if (result == OPTIONS_RUN && options->json != NULL) {
        result = check_place(&table, "json", options->json);
    }
    if (result == OPTIONS_RUN && options->svg != NULL) {
        result = check_place(&table, "svg", options->svg);
    }
    // Last, so that a fault is reported alone.
    if (result == OPTIONS_RUN) {
        note_unused(lab_name, set, is_given);
    }
    return result;
}
