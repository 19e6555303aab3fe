// Lab 10: trace spheres tile by tile and save the picture. Nothing to fill in here: see what is new
// since lab 07's, then go to intervals.cl and cone.cl. Part A, circles, has the same steps in
// circles.c.
//
// Flow: scene -> buffers -> kernel -> image; the banners below name the steps.
#include "circles.h"
#include "image.h"
#include "lab.h"
#include "scene3d.h"
#include "tile_buffers.h"

int main(int argc, char **argv)
{
    // ---- Options ---------------------------------------------------------------------------
    Lab lab = lab_begin(argc, argv, LAB_NAME,
                        "Traces spheres; a tile of rays goes through the kd-tree as one.",
                        OPTIONS_SCENE3D | OPTIONS_TREE | OPTIONS_DEVICE | OPTIONS_WORK |
                            OPTIONS_CIRCLES | OPTIONS_SHADOWS);
    if (lab.options.circles) {
        draw_circles(&lab);
        lab_end(&lab);
        return EXIT_SUCCESS;
    }

    // ---- Scene, device ---------------------------------------------------------------------
    Scene3D scene;
    require(scene3d_open(lab.options.scene, lab.options.width, lab.options.height, &scene));
    require(cl_setup_open(lab.options.device, &lab.cl));
    lab_describe(&lab, "n_spheres", scene.n_spheres, scene.width, scene.height);

    // ---- Buffers ---------------------------------------------------------------------------
    TileBuffers buffers;
    require(tile_buffers_create(&lab, &scene, &buffers));
    const TileShape tile = tile_shape(lab.cl.device);
    stats_integer(&lab.stats, "tile.width", tile.width);
    stats_integer(&lab.stats, "tile.height", tile.height);
    stats_integer(&lab.stats, "tile.lanes", tile.lanes);
    if (lab.options.shadows) {
        stats_integer(&lab.stats, "max_bounces", lab.options.n_bounces);
    }

    // ---- Kernel ----------------------------------------------------------------------------
    // One kernel draws, with --shadows another one. Where the work is counted, it is built again to
    // count, with the same arguments.
    const int is_lit = lab.options.shadows;
    lab_build_kernels(
        &lab, is_lit ? LAB_FOLDER "/render_lit_tiles.cl" : LAB_FOLDER "/render_tiles.cl",
        is_lit ? "render_lit_tiles" : "render_tiles", tile.options, scene.width, scene.height);
    for (int i = 0; i < lab.n_kernels; i++) {
        cl_kernel kernel = lab.kernels[i];
        tile_buffers_set(&buffers, &scene, kernel);  // arguments 0 to 13
        cl_uint next = 14;
        if (is_lit) {
            CL_CHECK(clSetKernelArg(kernel, next++, sizeof lab.options.n_bounces,
                                    &lab.options.n_bounces));
        }
        CL_CHECK(clSetKernelArg(kernel, next, sizeof lab.d_work[i], &lab.d_work[i]));
    }
    lab_draw(&lab, enqueue_tiles, lab.kernels[LAB_DRAWS], scene.width, scene.height);

    // ---- Image -----------------------------------------------------------------------------
    Image image;
    require(tile_buffers_read(&buffers, &scene, lab.cl.queue, &image));
    require(image_save(&image, lab.options.output));
    // Each pixel counts what its tile did for all of its rays.
    lab_count_work(&lab, enqueue_tiles, scene.width, scene.height, WORK_SPHERES);

    tile_buffers_free(&buffers);
    image_free(&image);
    scene3d_free(&scene);
    lab_end(&lab);
    return EXIT_SUCCESS;
}
