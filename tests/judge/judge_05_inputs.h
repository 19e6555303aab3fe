// The inputs of lab 05's functions, and how their answers are judged: a range of them for each
// check. Drawn in judge_05_inputs.c, judged in judge_05_functions.c.
#ifndef GRADER_JUDGE_05_INPUTS_H
#define GRADER_JUDGE_05_INPUTS_H

#include "jobs.h"
#include "judge.h"
#include "random.h"

// How many inputs each range has; the ranges of one function follow one another.
enum {
    N_ROOT_INPUTS = 600,  // 3 ranges: outside, inside, t_min
    N_SPHERE_INPUTS =
        800,  // 3 ranges: outside, inside, small and far; the textbook has the first 2
    N_NORMAL_INPUTS = 500,  // 2 ranges: outside, inside
    N_SHADE_INPUTS = 300,   // 3 ranges: one light before the surface, one behind it too, several
    N_LIGHTS = 40,
};

typedef struct Inputs05 {
    RootJob roots[3 * N_ROOT_INPUTS];
    SphereRayJob textbook[2 * N_SPHERE_INPUTS];
    SphereRayJob projection[3 * N_SPHERE_INPUTS];
    NormalJob normals[2 * N_NORMAL_INPUTS];
    ShadeJob shades[3 * N_SHADE_INPUTS];
    Light lights[N_LIGHTS];
} Inputs05;

void inputs_05_draw(Random *random, Inputs05 *inputs);

// Write the sections "roots", "textbook", "projection", "normals", "shades" and "lights". Returns
// 0, or -1.
int inputs_05_write(const Inputs05 *inputs, FILE *file);

// Judge a function's answers in one range. The message names the first wrong input, what was found
// and expected, and the mistake that explains every wrong answer, if one does.
Verdict inputs_05_judge_roots(const Inputs05 *inputs, int range, const Sections *answers);
Verdict inputs_05_judge_textbook(const Inputs05 *inputs, int range, const Sections *answers);
Verdict inputs_05_judge_projection(const Inputs05 *inputs, int range, const Sections *answers);
Verdict inputs_05_judge_normals(const Inputs05 *inputs, int range, const Sections *answers);
Verdict inputs_05_judge_shades(const Inputs05 *inputs, int range, const Sections *answers);

#endif
