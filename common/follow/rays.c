// The world of lab 04: rays alone, from a camera that flies (see world.h). Of a scene only the view
// counts.
//
// Read next: eye.h.
#include "camera_from_view.h"
#include "cl_memory.h"
#include "eye.h"

static void rays_close(World *world)
{
    if (world->own != NULL) {
        cl_memory_release(&world->d_image, 1);
        scene3d_free(world->own);
    }
    free(world->own);
    world->own = NULL;
}

static int rays_open(World *world)
{
    const Options *options = &world->lab->options;
    Scene3D *scene = world->own = world_allocate(sizeof *scene);
    if (scene3d_open(options->scene, options->width, options->height, scene) != 0) {
        return -1;
    }
    eye_open(world, scene);
    return cl_image_create(&world->lab->cl, world->width, world->height, &world->d_image);
}

static WorldData rays_data(const World *world)
{
    return (WorldData){
        .camera = camera_from_view(world->scene3d->view, world->width, world->height),
    };
}

const WorldKind RAYS = {
    .set = OPTIONS_SCENE3D,
    .n_numbers = 9,
    .pose_line = "from x y z, at x y z, up x y z",
    .askers = "rays",
    .open = rays_open,
    .close = rays_close,
    .place = eye_place,
    .move = eye_move,
    .film_pose = eye_film_pose,
    .data = rays_data,
};

void rays_set_directions(const World *world, cl_kernel kernel, cl_mem d_work)
{
    (void)d_work;  // nothing is counted
    const Camera camera = rays_data(world).camera;
    CL_CHECK(clSetKernelArg(kernel, 0, sizeof camera, &camera));
    CL_CHECK(clSetKernelArg(kernel, 1, sizeof world->width, &world->width));
    CL_CHECK(clSetKernelArg(kernel, 2, sizeof world->height, &world->height));
    CL_CHECK(clSetKernelArg(kernel, 3, sizeof world->d_image, &world->d_image));
}
