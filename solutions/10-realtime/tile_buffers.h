// What the kernels of lab 10 take: the scene, its tree with the spheres in the leaves' order, the
// picture as bytes; and the shape of a tile. Given; labs 05 and 08 have the same steps.
#ifndef TILE_BUFFERS_H
#define TILE_BUFFERS_H

#include "image.h"
#include "lab.h"
#include "scene3d.h"
#include "scene_buffers.h"
#include "tree3d.h"

typedef struct TileBuffers {
    SceneBuffers scene;
    cl_mem d_nodes;
    cl_mem d_sphere_ids;
    cl_mem d_leaf_spheres;  // the sphere of each id
    BBox3D bounds;          // widened: see box_widened()
    cl_mem d_pixels;        // [height * width], RGBA, a byte each
} TileBuffers;

// How deep the tree grows and how small its leaves get; 0 stands for what is best here.
KdTreeLimits tile_tree_limits(int max_depth, int leaf_size);

// Build a tree by cost (lab 08), copy scene and tree to the device and make the picture's buffer.
// Returns 0, or -1 after one message on stderr. Release with tile_buffers_free().
int tile_buffers_create(Lab *lab, const Scene3D *scene, TileBuffers *buffers);

// Release them; zeroed TileBuffers are fine.
void tile_buffers_free(TileBuffers *buffers);

// Set a kernel's arguments 0 to 13, which render_tiles.cl and render_lit_tiles.cl have alike.
void tile_buffers_set(const TileBuffers *buffers, const Scene3D *scene, cl_kernel kernel);

// The picture as floats from 0 to 1. Returns 0, or -1 after one message on stderr. Release with
// image_free().
int tile_buffers_read(const TileBuffers *buffers, const Scene3D *scene, cl_command_queue queue,
                      Image *image);

// A tree's spheres on the device in the order in which the leaves test them: a sphere that is in
// two leaves is stored twice. Returns NULL after one message on stderr when memory runs out.
// Release with clReleaseMemObject.
cl_mem leaf_spheres_create(const Lab *lab, const Scene3D *scene, const KdTree3D *tree);

// A picture as bytes on the device, [height * width], RGBA, red lowest; all 0. Release with
// clReleaseMemObject.
cl_mem pixels_create(const ClSetup *cl, int width, int height);

// Such a picture in the host's memory, as floats from 0 to 1; image is of its size.
void pixels_unpack(const u32 *pixels, Image *image);

// Wait for what is queued and copy a picture to the host, unpacked; image is of its size.
void pixels_read(cl_command_queue queue, cl_mem d_pixels, Image *image);

// What a device is given at once: a tile of width x height pixels, in vectors of `lanes`. The three
// become -D options of its kernel (lanes.h).
typedef struct TileShape {
    int width, height;  // pixels
    int lanes;
    size_t group_side;    // a work-group has this number of tiles, squared
    const char *options;  // for the kernel's build
} TileShape;

// The shape for a kind of device, as measured (slides-notes/notes-realtime.md, sections 2 and 5).
TileShape tile_shape(cl_device_id device);

// Launch a kernel with one work-item a tile of this shape over width x height pixels.
void enqueue_tiles_of(cl_command_queue queue, cl_kernel kernel, TileShape tile, int width,
                      int height);

// The device of a queue.
cl_device_id queue_device(cl_command_queue queue);

// Launch a kernel with one work-item a tile over width x height pixels, as EnqueuePixels (lab.h).
void enqueue_tiles(cl_command_queue queue, cl_kernel kernel, int width, int height);

#endif
