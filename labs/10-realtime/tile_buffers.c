// What the kernel of lab 10 takes (see tile_buffers.h).
//
// Flow: scene -> BUFFERS -> KERNEL -> IMAGE. Read next: main.c, render_tiles.cl.
#include "tile_buffers.h"

#include "camera_from_view.h"
#include "cl_memory.h"
#include "complain.h"
#include "kdtree3d_sah.h"
#include "tree_report.h"

// ---- Shape --------------------------------------------------------------------------------------

TileShape tile_shape(cl_device_id device)
{
    // A CPU's is what lanes.h has by itself. One tile keeps a core busy, and PoCL puts the private
    // variables of a whole work-group on one stack: with large groups that is too small.
    static const TileShape of_cpu = {8, 8, 16, 1, KERNEL_OPTIONS};
    static const TileShape of_gpu = {2, 2, 4, 8,
                                     KERNEL_OPTIONS " -DLANES=4 -DTILE_WIDTH=2 -DTILE_HEIGHT=2"};
    cl_device_type type;
    CL_CHECK(clGetDeviceInfo(device, CL_DEVICE_TYPE, sizeof type, &type, NULL));
    return type & CL_DEVICE_TYPE_GPU ? of_gpu : of_cpu;
}

// Tiles along a side of the picture, rounded up to whole work-groups.
static size_t count_tiles(int n_pixels, int tile_side, size_t group_side)
{
    const size_t n_tiles = (size_t)((n_pixels + tile_side - 1) / tile_side);
    return (n_tiles + group_side - 1) / group_side * group_side;
}

void enqueue_tiles_of(cl_command_queue queue, cl_kernel kernel, TileShape tile, int width,
                      int height)
{
    const size_t local_size[2] = {tile.group_side, tile.group_side};
    const size_t global_size[2] = {count_tiles(width, tile.width, tile.group_side),
                                   count_tiles(height, tile.height, tile.group_side)};
    CL_CHECK(
        clEnqueueNDRangeKernel(queue, kernel, 2, NULL, global_size, local_size, 0, NULL, NULL));
}

cl_device_id queue_device(cl_command_queue queue)
{
    cl_device_id device;
    CL_CHECK(clGetCommandQueueInfo(queue, CL_QUEUE_DEVICE, sizeof device, &device, NULL));
    return device;
}

void enqueue_tiles(cl_command_queue queue, cl_kernel kernel, int width, int height)
{
    enqueue_tiles_of(queue, kernel, tile_shape(queue_device(queue)), width, height);
}

// ---- Pixels -------------------------------------------------------------------------------------

cl_mem pixels_create(const ClSetup *cl, int width, int height)
{
    const size_t n_bytes = (size_t)width * (size_t)height * sizeof(cl_uint);
    cl_int error;
    cl_mem d_pixels = clCreateBuffer(cl->context, CL_MEM_WRITE_ONLY, n_bytes, NULL, &error);
    CL_CHECK_CREATED(error, clCreateBuffer);
    // New memory holds whatever was there. A pixel that no work-item writes shall be black.
    const cl_uint black = 0;
    CL_CHECK(
        clEnqueueFillBuffer(cl->queue, d_pixels, &black, sizeof black, 0, n_bytes, 0, NULL, NULL));
    return d_pixels;
}

void pixels_unpack(const u32 *pixels, Image *image)
{
    const size_t n_pixels = (size_t)image->width * (size_t)image->height;
    for (size_t i = 0; i < n_pixels; i++) {
        for (int channel = 0; channel < IMAGE_CHANNELS; channel++) {
            image->pixels[i * IMAGE_CHANNELS + (size_t)channel] =
                (float)(pixels[i] >> (8 * channel) & 0xff) / 255.0f;
        }
    }
}

void pixels_read(cl_command_queue queue, cl_mem d_pixels, Image *image)
{
    const size_t n_pixels = (size_t)image->width * (size_t)image->height;
    // Mapped, not read: on a CPU the picture is where the kernel wrote it.
    cl_int error;
    cl_uint *pixels = clEnqueueMapBuffer(queue, d_pixels, CL_TRUE, CL_MAP_READ, 0,
                                         n_pixels * sizeof *pixels, 0, NULL, NULL, &error);
    CL_CHECK_CREATED(error, clEnqueueMapBuffer);
    pixels_unpack(pixels, image);
    CL_CHECK(clEnqueueUnmapMemObject(queue, d_pixels, pixels, 0, NULL, NULL));
}

// ---- Tree ---------------------------------------------------------------------------------------

cl_mem leaf_spheres_create(const Lab *lab, const Scene3D *scene, const KdTree3D *tree)
{
    Sphere *leaf_spheres = malloc((tree->n_sphere_ids + 1) * sizeof *leaf_spheres);
    if (leaf_spheres == NULL) {
        complain("%s: no memory for %u spheres", lab->name, tree->n_sphere_ids);
        return NULL;
    }
    for (u32 i = 0; i < tree->n_sphere_ids; i++) {
        leaf_spheres[i] = scene->spheres[tree->sphere_ids[i]];
    }
    cl_mem d_leaf_spheres =
        cl_buffer_create(&lab->cl, leaf_spheres, tree->n_sphere_ids * sizeof *leaf_spheres);
    free(leaf_spheres);
    return d_leaf_spheres;
}

// Leaves are larger than lab 08's: a sphere that the whole tile misses costs one test for all rays,
// where a node's step always costs.
#define LEAF_SIZE 8

KdTreeLimits tile_tree_limits(int max_depth, int leaf_size)
{
    return (KdTreeLimits){max_depth > 0 ? max_depth : TODO_SIZE + 1,
                          leaf_size > 0 ? leaf_size : LEAF_SIZE};
}

static int tree_create(Lab *lab, const Scene3D *scene, TileBuffers *buffers)
{
    const KdTreeLimits limits = tile_tree_limits(lab->options.max_depth, lab->options.leaf_size);
    KdTree3D tree;
    const double start = stats_clock_ms();
    if (kdtree3d_build_sah(scene->spheres, (u32)scene->n_spheres, limits, &tree) != 0) {
        return -1;
    }
    const double build_ms = stats_clock_ms() - start;
    // The kernel follows every id without asking.
    int result = tree3d_check(&tree, (u32)scene->n_spheres);
    result = result == 0 ? tree_report(&tree, "tree", build_ms, &lab->stats) : result;
    if (result == 0) {
        buffers->bounds = box_widened(tree.bounds);
        buffers->d_nodes = cl_buffer_create(&lab->cl, tree.nodes, tree.n_nodes * sizeof(KdNode3));
        buffers->d_sphere_ids =
            cl_buffer_create(&lab->cl, tree.sphere_ids, tree.n_sphere_ids * sizeof(u32));
        buffers->d_leaf_spheres = leaf_spheres_create(lab, scene, &tree);
        result = buffers->d_leaf_spheres != NULL ? 0 : -1;
    }
    tree3d_free(&tree);
    return result;
}

// ---- Buffers ------------------------------------------------------------------------------------

int tile_buffers_create(Lab *lab, const Scene3D *scene, TileBuffers *buffers)
{
    *buffers = (TileBuffers){0};
    if (scene_buffers_create(&lab->cl, scene, &buffers->scene) != 0 ||
        tree_create(lab, scene, buffers) != 0) {
        return -1;
    }
    buffers->d_pixels = pixels_create(&lab->cl, scene->width, scene->height);
    return 0;
}

void tile_buffers_free(TileBuffers *buffers)
{
    const cl_mem memory[] = {buffers->d_nodes, buffers->d_sphere_ids, buffers->d_leaf_spheres,
                             buffers->d_pixels};
    cl_memory_release(memory, sizeof memory / sizeof *memory);
    scene_buffers_free(&buffers->scene);
    *buffers = (TileBuffers){0};
}

void tile_buffers_set(const TileBuffers *buffers, const Scene3D *scene, cl_kernel kernel)
{
    const Camera camera = camera_from_view(scene->view, scene->width, scene->height);
    const SceneBuffers *spheres = &buffers->scene;
    CL_CHECK(clSetKernelArg(kernel, 0, sizeof spheres->d_spheres, &spheres->d_spheres));
    CL_CHECK(clSetKernelArg(kernel, 1, sizeof spheres->d_material_ids, &spheres->d_material_ids));
    CL_CHECK(clSetKernelArg(kernel, 2, sizeof spheres->d_materials, &spheres->d_materials));
    CL_CHECK(clSetKernelArg(kernel, 3, sizeof spheres->d_lights, &spheres->d_lights));
    CL_CHECK(clSetKernelArg(kernel, 4, sizeof scene->n_lights, &scene->n_lights));
    CL_CHECK(clSetKernelArg(kernel, 5, sizeof scene->background, &scene->background));
    CL_CHECK(clSetKernelArg(kernel, 6, sizeof camera, &camera));
    CL_CHECK(clSetKernelArg(kernel, 7, sizeof scene->width, &scene->width));
    CL_CHECK(clSetKernelArg(kernel, 8, sizeof scene->height, &scene->height));
    CL_CHECK(clSetKernelArg(kernel, 9, sizeof buffers->d_pixels, &buffers->d_pixels));
    CL_CHECK(clSetKernelArg(kernel, 10, sizeof buffers->d_nodes, &buffers->d_nodes));
    CL_CHECK(clSetKernelArg(kernel, 11, sizeof buffers->d_sphere_ids, &buffers->d_sphere_ids));
    CL_CHECK(clSetKernelArg(kernel, 12, sizeof buffers->bounds, &buffers->bounds));
    CL_CHECK(clSetKernelArg(kernel, 13, sizeof buffers->d_leaf_spheres, &buffers->d_leaf_spheres));
}

int tile_buffers_read(const TileBuffers *buffers, const Scene3D *scene, cl_command_queue queue,
                      Image *image)
{
    if (image_create(scene->width, scene->height, image) != 0) {
        return -1;
    }
    pixels_read(queue, buffers->d_pixels, image);
    return 0;
}
