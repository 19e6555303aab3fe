// The command line: the same options in every lab, and in the same words.
//
// Flow: SCENE -> buffers -> kernel -> image -> comparison: what the user wants, before all else.
// Read next: scene2d.h.
//
//     --scene NAME      a .csv file or a generator (scene2d.h)     --frames N      draw N times
//     --size WxH        the picture's size                         --stats FILE    figures as JSON
//     --output FILE     .png or .exr                               --device D      number or name
//     --max-depth N     levels of the tree (labs with trees)       --list-devices
//     --leaf-size N     circles at which a node stays a leaf       --help
#ifndef COMMON_OPTIONS_H
#define COMMON_OPTIONS_H

// Which options a lab uses besides those that all do. It takes the others too, so that one command
// line serves every lab, and notes on stderr that they are not used.
enum {
    OPTIONS_SCENE = 1,   // --scene
    OPTIONS_TREE = 2,    // --max-depth, --leaf-size
    OPTIONS_DEVICE = 4,  // --device
};

#define OPTIONS_DEFAULT_MAX_DEPTH 16
#define OPTIONS_DEFAULT_LEAF_SIZE 8

// The most levels a 2D tree may have: a limit for the user's sake, as a level can double the nodes.
#define OPTIONS_LARGEST_MAX_DEPTH 24

typedef struct Options {
    const char *scene;   // as given; "random" when it was not
    int width, height;   // 0, 0: not given
    const char *output;  // as given; build/NN-name.png when it was not
    const char *device;  // as given, or NULL
    int n_frames;        // at least 1
    const char *stats;   // or NULL
    int max_depth;       // levels, the root's included
    int leaf_size;       // targetElementsPerNode
} Options;

typedef enum OptionsResult {
    OPTIONS_RUN,   // go on
    OPTIONS_DONE,  // --help or --list-devices was answered: end with EXIT_SUCCESS
    OPTIONS_BAD,   // one message was printed: end with EXIT_FAILURE
} OptionsResult;

// Read the command line of lab `lab_name` ("01-naive-2d").
//   what   one sentence for --help: what the program draws
//   set    OPTIONS_... that the lab uses; for each other one that is given, one note is printed:
//          "00-hello-pixels: --scene is not used in this lab"
// --output is checked early: an ending other than .png and .exr, or a folder that does not exist or
// cannot be written, is refused before anything is computed; so is such a folder of --stats. The
// default's folder is made.
OptionsResult options_parse(int argc, char **argv, const char *lab_name, const char *what, int set,
                            Options *options);

#endif
