// The figures of the second half.
#ifndef TESTS_FIGURES3D_H
#define TESTS_FIGURES3D_H

#include "figures.h"

// Of the worked example's ray.
void draw_slabs(FILE *file, const Followed *followed);       // 07-slabs.svg
void draw_stack(FILE *file, const Followed *followed);       // 07-stack.svg
void draw_half_chord(FILE *file, const Followed *followed);  // 05-half-chord.svg

// Of a ray whose eye is inside the box, with all four cases on it.
void draw_cases(FILE *file, const Followed *followed);  // 07-cases.svg

// Of no scene.
void draw_hits(FILE *file, const Followed *followed);    // 05-hits.svg
void draw_camera(FILE *file, const Followed *followed);  // 04-camera.svg

#endif
