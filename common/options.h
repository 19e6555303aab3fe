// The command line: the same options in every lab, and in the same words.
//
// They are read before all else. Read next: scene2d.h, scene3d.h.
//
//     --scene NAME      a file or a generator (scene2d.h, 3d)      --frames N      draw N times
//     --size WxH        the picture's size                         --stats FILE    figures as JSON
//     --output FILE     .png or .exr                               --device D      number or name
//     --max-depth N     levels of the tree (labs with trees)       --list-devices
//     --leaf-size N     elements at which a node stays a leaf      --help
//     --heat-map        save the work of each pixel, too           --textbook      (lab 05)
//     --bounces N       mirrored at most N times (labs 09, 10)     --acne          (lab 09)
//     --circles         a scene of circles (lab 10)                --shadows       (lab 10)
//     --path FILE, --record FILE, --movie FOLDER, --script FILE      (windows)
//     --pixel X,Y, --json FILE, --svg FILE                           (common/follow)
#ifndef COMMON_OPTIONS_H
#define COMMON_OPTIONS_H

#include "option_table.h"

// Which options a lab uses besides those that all do. It takes the others too, so that one command
// line serves every lab, and notes on stderr that they are not used.
enum {
    OPTIONS_SCENE = 1,       // --scene, of circles
    OPTIONS_TREE = 2,        // --max-depth, --leaf-size
    OPTIONS_DEVICE = 4,      // --device
    OPTIONS_SCENE3D = 8,     // --scene, of spheres
    OPTIONS_WORK = 16,       // --heat-map; --stats then counts the work, too
    OPTIONS_TEXTBOOK = 32,   // --textbook
    OPTIONS_MIRRORS = 64,    // --bounces, --acne
    OPTIONS_VIEW = 128,      // --path, --record, --movie, --script: of windows (common/view)
    OPTIONS_PIXEL = 256,     // --pixel, --json, --svg: of a followed pixel (common/follow)
    OPTIONS_CIRCLES = 512,   // --circles, which makes --scene one of circles
    OPTIONS_SHADOWS = 1024,  // --shadows, and --bounces with it
};

// The picture's size in pixels in a lab without a scene.
#define OPTIONS_DEFAULT_WIDTH 640
#define OPTIONS_DEFAULT_HEIGHT 480

#define OPTIONS_DEFAULT_MAX_DEPTH 16
#define OPTIONS_DEFAULT_LEAF_SIZE 8

// The most levels that may be asked for. The builders refuse trees that grow too large or too deep.
#define OPTIONS_LARGEST_MAX_DEPTH 64

#define OPTIONS_DEFAULT_BOUNCES 5
#define OPTIONS_MOST_BOUNCES 64

typedef struct Options {
    const char *scene;   // as given; "random", of spheres "sphereflake", when it was not
    int width, height;   // 0, 0: not given
    const char *output;  // as given; build/NN-name.png when it was not
    const char *device;  // as given, or NULL
    int n_frames;        // at least 1
    const char *stats;   // or NULL
    int max_depth;       // levels, the root's included; in 3D 0 when not given
    int leaf_size;       // targetElementsPerNode; in 3D 0 when not given
    int heat_map;        // 1 when asked for
    int textbook;        // 1 when asked for
    int n_bounces;       // a ray is mirrored at most this often
    int acne;            // 1 when asked for
    int circles;         // 1 when asked for
    int shadows;         // 1 when asked for
    const char *path, *record, *movie, *script;  // as given, or NULL
    int pixel_x, pixel_y;                        // -1 when not given
    const char *json, *svg;                      // as given, or NULL
    int help, list_devices;                      // answered by options_parse()
} Options;

// Read the command line of lab `lab_name` ("01-naive-2d").
//   what   one sentence for --help: what the program draws
//   set    OPTIONS_... that the lab uses; for each other one that is given, one note is printed:
//          "00-hello-pixels: --scene is not used in this lab"
// --output is checked early: an ending other than .png and .exr, or a folder that does not exist or
// cannot be written, is refused before anything is computed; so is such a folder of --stats, and
// the picture's own file, however it is spelt. The default's folder is made. A program that is
// started in another folder than the course's top folder says which one that is, and does nothing.
OptionsResult options_parse(int argc, char **argv, const char *lab_name, const char *what, int set,
                            Options *options);

#endif
