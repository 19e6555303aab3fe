// The window of a lab: `make view LAB=07`. What a lab has to show stands in
// common/follow/NN-name.c.
//
// Read next: view.c.
#ifndef VIEW_VIEW_H
#define VIEW_VIEW_H

#include "world.h"

// Run the window of a lab until the user ends it. Ends the program as a lab's does: after one
// message, with EXIT_FAILURE, where the command line is wrong, the scene cannot be opened, a kernel
// does not build, or there is no display. Returns EXIT_SUCCESS.
int view_run(int argc, char **argv, const WorldLab *world_lab);

#endif
