// Known mistakes of lit_color: a point's lights, added up in another way. See judge_09_lit.c.
#ifndef JUDGE_JUDGE_09_LIGHTS_H
#define JUDGE_JUDGE_09_LIGHTS_H

#include "judge_09.h"

// What comes of a point's lights in an answer with a mistake.
typedef struct SeenLights SeenLights;
typedef OracleNear MistakenSum(const SeenLights *lights);

// Mistakes of the rays alone; number 0 is none.
enum { LIT_ASKS_ALL = 1, LIT_ASKS_TWICE, LIT_UNCOUNTED };

// A known mistake, and what is said about it.
typedef struct LitMistake {
    Cause cause;
    MistakenSum *sum;     // NULL: colours are right
    int most_lights;      // that are asked; 0: all of them
    double least_cosine;  // at which light arrives
    double least_light;   // darker lights are not asked,
    double least_kd;      // nor any for surfaces that scatter less
    int kd_again;         // kd counts twice,
    int color_again;      // or the material's colour
} LitMistake;

enum { N_LIT_MISTAKES = 41 };
extern const LitMistake lit_mistakes_09[N_LIT_MISTAKES];

// The colour that comes of a mistake with a sum: anything where float may decide otherwise whether
// a light arrives.
OracleNear lights_09_mistaken(const Job09 *job, const LitJob *lit, const LitMistake *mistake);

// A vector of length |x| along axis 0, 1 or 2.
Vec3 along_09(int axis, float x);

// A colour for light number i. One in five is all red, green or blue, so that no colour by itself
// says whether a light gives anything.
Vec3 light_09_color(Random *random, int i);

#endif
