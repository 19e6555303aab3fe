// Known mistakes of nearest_root, and of intersect_textbook and intersect_sphere, which call it.
// See judge_05_roots.c.
#ifndef JUDGE_JUDGE_05_MISTAKES_H
#define JUDGE_JUDGE_05_MISTAKES_H

#include "diagnosis.h"
#include "jobs_05.h"
#include "oracle3d.h"

// What an answer to nearest_root with a mistake returns.
typedef float MistakenRoot(RootJob job, float t_near, float t_far);

// What it returns for a negative disc, and where no root is beyond t_min.
typedef struct Misses {
    float by_disc, by_t_min;
} Misses;

// What an answer to the other two hands to nearest_root.
typedef struct Quadratic {
    double b, disc;
} Quadratic;
typedef Quadratic MistakenQuadratic(double b, double c2, double radius);

// A known mistake, and what is said about it; number 0 is none.
typedef struct RootMistake {
    Cause cause;
    OracleRules3D rules;
    MistakenRoot *root;            // nearest_root only;
    const Misses *misses;          // right ones where it is NULL
    MistakenQuadratic *quadratic;  // the other two only
    int touching_missed;           // no hit where disc is 0
    int t_min_counts;              // nearest_root: a hit at t_min itself
    int is_textbook;               // intersect_sphere in the textbook's form
    int is_lost_afar;              // far from the scene's origin anything, and all else is right
    int is_missed;                 // some hits are none, and all else is right
} RootMistake;

// Number 0 is none.
enum { N_ROOT_MISTAKES = 29 };
extern const RootMistake root_mistakes_05[N_ROOT_MISTAKES];

#endif
