// A film: a path through a scene as pictures, one file a frame. Needs no window.
//
// Read next: film.c, movie.sh.
#ifndef VIEW_FILM_H
#define VIEW_FILM_H

#include "frame.h"
#include "poses.h"

// Draw the world from each pose of a path and save the pictures: FOLDER/frame-00001.png and on. A
// path of no pose stands for the world's own, once round the scene in four seconds.
//   folder   made where it is not there
// Returns 0, or -1 after one message on stderr.
int film_make(World *world, Frame *frame, const Poses *path, const char *folder);

#endif
