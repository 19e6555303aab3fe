// A trick of lab 10's kernels, and how to leave it out: so that it can be seen what it brings.
//
// A kernel without a trick is the solution's text with a few words changed. The changed texts are
// kept beside the figures, so that everybody can read what was measured. A change whose place is no
// longer in the solution ends the bench with a message.
// Used by bench_tricks.c.
#ifndef BENCH_TRICK_H
#define BENCH_TRICK_H

#include "tile_buffers.h"

// Words of one of the lab's files, and what stands in their place. They are there exactly once.
typedef struct TextChange {
    const char *file;
    const char *from;
    const char *to;
} TextChange;

enum { MAX_CHANGES = 3 };

typedef struct Trick {
    const char *name;                 // of the folder with its texts
    const char *title;                // what is done without it, in the CSV file
    TextChange changes[MAX_CHANGES];  // those with a file
    int width, height, lanes;  // of a tile where these are the trick; 0: as the device has them
    int has_small_leaves;      // the tree's hold as few spheres as lab 08's
    int in_scene_order;        // the kernel takes the scene's spheres for those of the leaves
    int has_image;             // it draws into an image of floats, not into bytes
    int has_hidden_circles;    // they are in the leaves' lists (hidden_circles.h)
} Trick;

// The two parts of the lab, with their tricks. The first of each is none: all tricks are there.
typedef enum Part {
    CIRCLES,  // Part A
    SPHERES,  // Part B
    N_PARTS,
} Part;

enum { MAX_TRICKS = 10 };

typedef struct PartTricks {
    const char *program;  // the file of the lab
    const char *kernel;
    const Trick *tricks;
    int n_tricks;  // at most MAX_TRICKS
} PartTricks;
extern const PartTricks PART_TRICKS[N_PARTS];

// The tiles that a kernel without a trick draws, but for the build's options.
//   usual   those of the kernel with all
TileShape trick_shape(const Trick *trick, TileShape usual);

// Copy what a device compiles of the lab, without a trick.
//   folder   is made where it is missing; one in a folder that is there
// Returns 0, or -1 after one message.
int trick_write(const Trick *trick, const char *folder);

#endif
