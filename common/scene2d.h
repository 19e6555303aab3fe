// 2D scenes: circles from a CSV file or from a generator. SCENES.md lists all.
//
// Generated centres, radii and pixels lie on a grid of 1/16 px: every comparison is then exact in
// float, whatever the order of the arithmetic, and two right pictures are equal to the bit.
//
// A lab calls scene2d_open() and scene2d_free(); what is below is for what makes or reads scenes.
// Read next: a lab's main.c.
#ifndef COMMON_SCENE2D_H
#define COMMON_SCENE2D_H

#include "circle.h"

#include <stdint.h>
#include <stdio.h>

typedef struct Scene2D {
    Circle *circles;  // [n_circles], NULL when there is none
    int n_circles;
    int width;  // the picture it is made for, pixels
    int height;
} Scene2D;

// Load or generate the scene that `name` stands for (SCENES.md): "random:n=100", "a.csv".
//   width, height   the picture's size; 0, 0 when the user gave none: the scene then chooses
//                   (10x10 for the example, SCENE2D_DEFAULT_SIZE squared for the others)
// Returns 0, or -1 after one message on stderr that names the file and line or the argument, what
// was found and what was expected. Release with scene2d_free().
int scene2d_open(const char *name, int width, int height, Scene2D *scene);

// Release the circles; a zeroed Scene2D is fine.
void scene2d_free(Scene2D *scene);

// ---- For what makes or reads a scene ------------------------------------------------------------

// The picture's size where neither --size nor the scene says one.
#define SCENE2D_DEFAULT_SIZE 1024

// What `random` makes by default: as many circles as the lecture draws, whose radii are unknown.
#define SCENE2D_DEFAULT_CIRCLES 8192

// The most circles of a scene: 320 MB.
#define SCENE2D_MAX_CIRCLES 10000000

// Generated centres and radii are whole numbers of steps; this many make a pixel.
#define SCENE2D_STEPS_PER_PIXEL 16

// The largest generated radius whose boundary crosses the picture. In steps of 1/16 px its square
// stays below 2^24, where float is exact; a larger one would round, and pictures could differ.
#define SCENE2D_MAX_RADIUS 255

// Circles in files have no larger coordinate and radius: kernels square distances in float.
#define SCENE2D_LARGEST 1e18

// Every name of a scene but the edge cases', for messages.
#define SCENE2D_NAMES "FILE.csv, random[:n=N,seed=S,min=R,max=R]"

// The same for those that are made, never a file.
int scene2d_generate(const char *name, int width, int height, Scene2D *scene);

// Make room for a scene of this many circles, all zero; labs do not need it. Returns 0, or -1 after
// one message on stderr (no memory).
int scene2d_create(int n_circles, int width, int height, Scene2D *scene);

// Read circles from CSV text. The first line names the columns, in any order; unknown names are an
// error, as are missing columns, text that is no number, NaN, infinities, a negative radius. Lines
// that start with # are comments, empty lines are skipped; a file without a header is an error, a
// header alone is an empty scene. Colours go from 0 to 1; a missing column `a` is 1.
//   name   what messages call the file
// Sets circles and n_circles only. Returns 0, or -1 after one message on stderr.
int scene2d_read_csv(FILE *file, const char *name, Scene2D *scene);

// The random scene. width, height: where centres may lie; radii are rounded to the grid,
// 0 <= min_radius <= max_radius <= SCENE2D_MAX_RADIUS. The same arguments give the same scene on
// every machine. Returns 0, or -1 after one message on stderr (no memory).
int scene2d_random(int n_circles, uint64_t seed, float min_radius, float max_radius, int width,
                   int height, Scene2D *scene);

// The edge cases by name ("example" included), or NULL for the index after the last:
// for help texts and tests.
const char *scene2d_edge_case(int index);

#endif
