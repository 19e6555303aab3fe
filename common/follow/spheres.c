// The world from lab 05 on: spheres, seen from a camera that flies (see world.h).
//
// Camera and buffers are those of labs 04 and 05. Read next: eye.h.
#include "camera_from_view.h"
#include "cl_memory.h"
#include "eye.h"
#include "world_spheres.h"

// ---- The tree -------------------------------------------------------------------------------

static void tree_release(Spheres *own)
{
    const cl_mem memory[] = {own->d_nodes, own->d_sphere_ids, own->d_leaf_spheres, own->d_pixels};
    cl_memory_release(memory, sizeof memory / sizeof *memory);
    own->d_leaf_spheres = own->d_pixels = NULL;
    tree3d_free(&own->tree);
}

static int spheres_grow(World *world)
{
    Spheres *own = world->own;
    const u32 n_spheres = (u32)own->scene.n_spheres;
    KdTree3D tree = {0};
    TreeFigures3D counted;
    const double start = stats_clock_ms();
    int result = world->tree->build.spheres(own->scene.spheres, n_spheres, world->limits, &tree);
    const double build_ms = stats_clock_ms() - start;
    // The kernel follows every id without asking.
    if (result != 0 || tree3d_check(&tree, n_spheres) != 0 ||
        tree3d_figures(&tree, &counted) != 0) {
        tree3d_free(&tree);
        return -1;
    }
    tree_release(own);
    const ClSetup *cl = &world->lab->cl;
    own->tree = tree;
    own->bounds = box_widened(tree.bounds);
    own->d_nodes = cl_buffer_create(cl, tree.nodes, tree.n_nodes * sizeof *tree.nodes);
    own->d_sphere_ids =
        cl_buffer_create(cl, tree.sphere_ids, tree.n_sphere_ids * sizeof *tree.sphere_ids);
    world->figures = (TreeFigures){tree.n_nodes, tree.n_sphere_ids, counted.depth, build_ms};
    if (world->tree->complete != NULL) {
        world->tree->complete(world);
    }
    return 0;
}

// ---- Opening and closing ---------------------------------------------------------------------

static void spheres_close(World *world)
{
    Spheres *own = world->own;
    if (own != NULL) {
        tree_release(own);
        scene_buffers_free(&own->buffers);
        scene3d_free(&own->scene);
    }
    free(own);
    world->own = NULL;
}

static int spheres_open(World *world)
{
    const Options *options = &world->lab->options;
    Spheres *own = world->own = world_allocate(sizeof *own);
    if (scene3d_open(options->scene, options->width, options->height, &own->scene) != 0 ||
        scene_buffers_create(&world->lab->cl, &own->scene, &own->buffers) != 0) {
        return -1;
    }
    eye_open(world, &own->scene);
    world->n_elements = own->scene.n_spheres;
    world->d_image = own->buffers.d_image;
    return 0;
}

static int spheres_find(const World *world, const f32 *element, int start)
{
    const Spheres *own = world->own;
    for (int i = 0; i < world->n_elements; i++) {
        const int id = (start + i) % world->n_elements;
        const Sphere sphere = own->scene.spheres[id];
        if (sphere.x == element[0] && sphere.y == element[1] && sphere.z == element[2] &&
            sphere.radius == element[3]) {
            return id;
        }
    }
    return -1;
}

static WorldData spheres_data(const World *world)
{
    const Spheres *own = world->own;
    return (WorldData){
        .spheres = own->scene.spheres,
        .tree3d = world->tree != NULL ? &own->tree : NULL,
        .bounds = own->bounds,
        .camera = camera_from_view(own->scene.view, world->width, world->height),
    };
}

const WorldKind SPHERES = {
    .set = OPTIONS_SCENE3D,
    .n_numbers = 9,
    .pose_line = "from x y z, at x y z, up x y z",
    .elements = "spheres",
    .askers = "rays",
    .open = spheres_open,
    .close = spheres_close,
    .place = eye_place,
    .grow = spheres_grow,
    .move = eye_move,
    .film_pose = eye_film_pose,
    .find = spheres_find,
    .data = spheres_data,
};

// ---- The kernels' arguments -----------------------------------------------------------------

void spheres_set_naive(const World *world, cl_kernel kernel, cl_mem d_work)
{
    const Spheres *own = world->own;
    scene_buffers_set(&own->buffers, &own->scene, kernel);  // arguments 0 to 9
    CL_CHECK(clSetKernelArg(kernel, 10, sizeof own->scene.n_spheres, &own->scene.n_spheres));
    CL_CHECK(clSetKernelArg(kernel, 11, sizeof d_work, &d_work));
}

void spheres_set_traced(const World *world, cl_kernel kernel)
{
    const Spheres *own = world->own;
    scene_buffers_set(&own->buffers, &own->scene, kernel);  // arguments 0 to 9
    CL_CHECK(clSetKernelArg(kernel, 10, sizeof own->d_nodes, &own->d_nodes));
    CL_CHECK(clSetKernelArg(kernel, 11, sizeof own->d_sphere_ids, &own->d_sphere_ids));
    CL_CHECK(clSetKernelArg(kernel, 12, sizeof own->bounds, &own->bounds));
}

void spheres_set_tree(const World *world, cl_kernel kernel, cl_mem d_work)
{
    spheres_set_traced(world, kernel);  // arguments 0 to 12
    CL_CHECK(clSetKernelArg(kernel, 13, sizeof d_work, &d_work));
}
