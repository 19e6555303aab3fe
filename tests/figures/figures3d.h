// The figures of the second half.
#ifndef TESTS_FIGURES3D_H
#define TESTS_FIGURES3D_H

#include "figures.h"

// Of the worked example's ray.
void draw_planes(FILE *file, const Followed *followed);      // 06-planes.svg
void draw_slabs(FILE *file, const Followed *followed);       // 07-slabs.svg
void draw_search3d(FILE *file, const Followed *followed);    // 07-search.svg
void draw_stack(FILE *file, const Followed *followed);       // 07-stack.svg
void draw_half_chord(FILE *file, const Followed *followed);  // 05-half-chord.svg

// 07-search.svg at another step; the step that it shows itself; a step in words, a line or a few;
// and where in the scene a point of that drawing is, or its nearest point from above.
void draw_search3d_step(FILE *file, const Followed *followed, u32 step, FigureShape shape);
u32 search3d_still_step(const Followed *followed);
void search3d_step_tell(FILE *file, const Followed *followed, u32 step);
void search3d_point(double x, double y, double *scene_x, double *scene_y);

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
void draw_ways(FILE *file, const Followed *followed);    // 10-light.svg

// 08-cost.svg with candidate plane `number` marked; it in words, a line or a few; and the number of
// the plane that is nearest to x in the drawing.
void draw_cost_plane(FILE *file, int number, FigureShape shape);
void cost_plane_tell(FILE *file, int number);
int cost_plane_at(double x);

#endif
