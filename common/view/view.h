// The window of a lab: `make view LAB=07`. Each lab's own file, NN-name.c, says what its kernels
// are, and calls this.
//
// Flow: SCENE -> BUFFERS -> KERNEL -> IMAGE -> comparison: all of it, frame by frame. Read next:
// view.c.
#ifndef VIEW_VIEW_H
#define VIEW_VIEW_H

#include "world.h"

typedef struct ViewLab {
    const char *name;       // LAB_NAME
    const char *what;       // one sentence for --help
    const WorldKind *kind;  // CIRCLES or SPHERES
    WorldBuilder build;     // of its tree
    int has_tree;
    const WorldKernel *kernels;  // [n_kernels], the lab's own first
    int n_kernels;
} ViewLab;

// Run the window of a lab until the user ends it. Ends the program as a lab's does: after one
// message, with EXIT_FAILURE, where the command line is wrong, the scene cannot be opened, a kernel
// does not build, or there is no display. Returns EXIT_SUCCESS.
int view_run(int argc, char **argv, const ViewLab *view_lab);

#endif
