// The figures of the second half.
#ifndef TESTS_FIGURES3D_H
#define TESTS_FIGURES3D_H

#include "figures.h"

// Of the worked example's ray.
void draw_planes(FILE *file, const Followed *followed);      // 06-planes.svg
void draw_slabs(FILE *file, const Followed *followed);       // 07-slabs.svg
void draw_stack(FILE *file, const Followed *followed);       // 07-stack.svg
void draw_half_chord(FILE *file, const Followed *followed);  // 05-half-chord.svg

// Of a ray whose eye is inside the box, with all four cases on it.
void draw_cases(FILE *file, const Followed *followed);  // 07-cases.svg

// Of a ray that hits first what is not seen.
void draw_balls(FILE *file, const Followed *followed);  // 07-balls.svg

// Of the pixel that is followed and those right of it.
void draw_lanes(FILE *file, const Followed *followed);  // 10-divergence.svg

// Of no scene.
void draw_hits(FILE *file, const Followed *followed);    // 05-hits.svg
void draw_camera(FILE *file, const Followed *followed);  // 04-camera.svg
void draw_cost(FILE *file, const Followed *followed);    // 08-cost.svg
void draw_light(FILE *file, const Followed *followed);   // 09-rays.svg
void draw_tile(FILE *file, const Followed *followed);    // 10-tile.svg

#endif
