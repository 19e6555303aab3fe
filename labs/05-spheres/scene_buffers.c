// A 3D scene on the device (see scene_buffers.h).
//
// Flow: scene -> BUFFERS -> kernel -> image. Called by main.c here and in lab 07. Read next:
// render_spheres.cl, which takes these parameters.
#include "scene_buffers.h"

#include "camera_from_view.h"
#include "cl_memory.h"

int scene_buffers_create(const ClSetup *cl, const Scene3D *scene, SceneBuffers *buffers)
{
    const size_t n_spheres = (size_t)scene->n_spheres;
    *buffers = (SceneBuffers){0};
    if (cl_image_create(cl, scene->width, scene->height, &buffers->d_image) != 0) {
        return -1;
    }
    buffers->d_spheres = cl_buffer_create(cl, scene->spheres, n_spheres * sizeof *scene->spheres);
    buffers->d_material_ids =
        cl_buffer_create(cl, scene->material_ids, n_spheres * sizeof *scene->material_ids);
    buffers->d_materials = cl_buffer_create(cl, scene->materials,
                                            (size_t)scene->n_materials * sizeof *scene->materials);
    buffers->d_lights =
        cl_buffer_create(cl, scene->lights, (size_t)scene->n_lights * sizeof *scene->lights);
    return 0;
}

void scene_buffers_free(SceneBuffers *buffers)
{
    cl_mem objects[] = {buffers->d_spheres, buffers->d_material_ids, buffers->d_materials,
                        buffers->d_lights, buffers->d_image};
    cl_memory_release(objects, sizeof objects / sizeof *objects);
    *buffers = (SceneBuffers){0};
}

void scene_buffers_set(const SceneBuffers *buffers, const Scene3D *scene, cl_kernel kernel)
{
    const Camera camera = camera_from_view(scene->view, scene->width, scene->height);
    CL_CHECK(clSetKernelArg(kernel, 0, sizeof buffers->d_spheres, &buffers->d_spheres));
    CL_CHECK(clSetKernelArg(kernel, 1, sizeof buffers->d_material_ids, &buffers->d_material_ids));
    CL_CHECK(clSetKernelArg(kernel, 2, sizeof buffers->d_materials, &buffers->d_materials));
    CL_CHECK(clSetKernelArg(kernel, 3, sizeof buffers->d_lights, &buffers->d_lights));
    CL_CHECK(clSetKernelArg(kernel, 4, sizeof scene->n_lights, &scene->n_lights));
    CL_CHECK(clSetKernelArg(kernel, 5, sizeof scene->background, &scene->background));
    CL_CHECK(clSetKernelArg(kernel, 6, sizeof camera, &camera));
    CL_CHECK(clSetKernelArg(kernel, 7, sizeof scene->width, &scene->width));
    CL_CHECK(clSetKernelArg(kernel, 8, sizeof scene->height, &scene->height));
    CL_CHECK(clSetKernelArg(kernel, 9, sizeof buffers->d_image, &buffers->d_image));
}
