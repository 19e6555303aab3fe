// A 3D scene on the device: the first arguments of every kernel that draws spheres. Given; lab 05
// and all later labs that draw use it.
#ifndef SCENE_BUFFERS_H
#define SCENE_BUFFERS_H

#include "cl_setup.h"
#include "scene3d.h"

typedef struct SceneBuffers {
    cl_mem d_spheres;
    cl_mem d_material_ids;
    cl_mem d_materials;
    cl_mem d_lights;
    cl_mem d_image;
} SceneBuffers;

// The number of a kernel's first argument that scene_buffers_set() leaves to the lab.
#define N_SCENE_ARGUMENTS 10

// Copy a scene to the device and make the picture's image. Returns 0, or -1 after one message on
// stderr (a picture larger than the device takes). Release with scene_buffers_free().
int scene_buffers_create(const ClSetup *cl, const Scene3D *scene, SceneBuffers *buffers);

// Release them; zeroed SceneBuffers are fine.
void scene_buffers_free(SceneBuffers *buffers);

// Set a kernel's first N_SCENE_ARGUMENTS arguments: spheres, material_ids, materials, lights,
// n_lights, background, camera, width, height, image.
void scene_buffers_set(const SceneBuffers *buffers, const Scene3D *scene, cl_kernel kernel);

#endif
