// What explains, drawn by program: the notes' figures that are no results. All numbers and
// decisions in them come from the solutions, their trees, the recorder of common/follow and the
// grader's oracles.
#ifndef TESTS_FIGURES_H
#define TESTS_FIGURES_H

#include "followed.h"
#include "svg.h"

// How a figure that can be touched is drawn (slides-notes/touch): as it stands in print, with its
// words; live, where the page has the words beside it; and that on a phone.
typedef enum FigureShape { SHAPE_STILL, SHAPE_WIDE, SHAPE_NARROW } FigureShape;

// One figure: `draw` is called with an open file.
typedef struct Figure {
    const char *name;  // "02-tree.svg"
    void (*draw)(FILE *file, const Followed *followed);
} Figure;

// Follow a pixel of a scene and draw figures of it, up to one whose name is NULL, into a folder.
// The options are those of the lab's program, with --pixel; the last one is followed by NULL.
// Ends the program after one message where something fails.
void figures_draw(const char *folder, char **options, const Figure *figures);

#endif
