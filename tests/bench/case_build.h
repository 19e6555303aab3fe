// A case of the bench of builds: one builder over one random scene.
//
// Scenes are alike, whatever their number of elements (circles or spheres): the more, the smaller,
// so that together they cover the same part of the picture, or fill the same part of the cube.
// Numbers are powers of four. From one to the next the tree gets two levels more, and in 2D its
// cells halve once in each direction: what is left to differ is the number.
// Read next: handed_on.h, tables.sql.
#ifndef BENCH_CASE_BUILD_H
#define BENCH_CASE_BUILD_H

#include "scene2d.h"
#include "scene3d.h"

// What is built, and how deep.
typedef enum Builder {
    MIDDLE_2D,        // lab 02, with a depth that grows with the scene
    MIDDLE_2D_FIXED,  // lab 02, at a fixed depth
    MIDDLE_3D,        // lab 06, with its usual limits, whose depth grows with the scene
    MIDDLE_3D_FIXED,  // lab 06, at a fixed depth
    BY_COST_3D,       // lab 08, with its usual limits: the cost ends it
    N_BUILDERS,
} Builder;

typedef struct BuilderRow {
    const char *name;  // in the CSV file
    int largest;       // number of elements; more would take too long for the bench
} BuilderRow;

extern const BuilderRow BUILDERS[N_BUILDERS];

enum { SMALLEST_SCENE = 1 << 10, LARGEST_SCENE = 1 << 20, SCENE_FACTOR = 4, N_SCENES = 6 };

// A finished tree. Its memory is what a device gets: each array as long as it is filled.
typedef struct TreeSize {
    double n_leaves;
    double n_listed;  // elements in all leaves' lists: one that overlaps two leaves is in both
    double n_bytes;
    double n_handed_on;  // elements of all nodes together (handed_on.h)
} TreeSize;

typedef struct BuildCase {
    Builder builder;
    int n_elements;
    TreeSize size;        // all zero until it is known
    double n_peak_bytes;  // most that the builder has asked for at one moment, with the tree
} BuildCase;

// A scene in 2D and in 3D, of as many elements. Start with {0}.
typedef struct BuildScene {
    Scene2D circles;
    Scene3D spheres;
} BuildScene;

// Make a scene. Returns 0, or -1 after one message. Release with build_scene_free(), after a
// failure too.
int build_scene_create(int n_elements, BuildScene *scene);
void build_scene_free(BuildScene *scene);

// Build the case's tree over its scene, note the memory that it took and, the first time, the size
// of the tree, and throw it away. Returns the milliseconds of processor time, or -1 after one
// message.
double case_build_time(BuildCase *build_case, const BuildScene *scene);

#endif
