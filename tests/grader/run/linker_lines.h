// What the linker says, in the lab's own paths: it knows files by where they were compiled.
//
// Used by variant_end.c.
#ifndef GRADER_LINKER_LINES_H
#define GRADER_LINKER_LINES_H

// Shorten paths in a compiler's output, in place, where the linker is what failed: of files of the
// course to what stands below its top folder, "labs/02-kdtree-2d-build/kdtree2d_build.c"; an object
// of no lasting name becomes "your code". Where the course lies on the grading machine is nobody's
// business, and names that change from run to run are of no use.
void linker_lines_shorten(char *output);

#endif
