// A 3D scene while a file is read: it grows sphere by sphere, and every material is kept once.
//
// Used by scene3d_nff.c and molecule.c, not by the labs. Read next: scene3d.h.
#ifndef COMMON_SCENE3D_BUILDER_H
#define COMMON_SCENE3D_BUILDER_H

#include "line_reader.h"
#include "scene3d.h"

// Begin with {.reader = ...} and all else zero.
typedef struct Scene3DBuilder {
    LineReader *reader;    // complaints go to its current line, and end the reading
    Scene3D scene;         // so far
    u32 *material_table;   // [n_material_slots], a hash table: index + 1 of a material, or 0
    u32 n_material_slots;  // a power of two, or 0
} Scene3DBuilder;

// Each of these adds one thing. Too many of them, or no memory, is a fault of the current line.

// Returns the material's index: of equal materials, to the bit, there is one.
u32 builder_add_material(Scene3DBuilder *builder, const Material *material);

void builder_add_sphere(Scene3DBuilder *builder, Sphere sphere, u32 material_id);

void builder_add_light(Scene3DBuilder *builder, Light light);

// Hand over the scene. Returns 0; or, when the reader has failed, releases everything, leaves
// *scene alone and returns -1.
int builder_finish(Scene3DBuilder *builder, Scene3D *scene);

#endif
