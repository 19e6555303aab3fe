// Rolling lab 08's scenes and the trees that are expected of them: see judge_08.h. The functions'
// inputs are rolled in judge_08_job.c.
#include "judge_08.h"

#include "random3d.h"
#include "scene_vary.h"

// The size of the report's drawings.
enum { WIDTH = 320, HEIGHT = 240 };

static int roll_named(TreeScene3D *scene, const char *name, KdTreeLimits limits)
{
    *scene = (TreeScene3D){.limits = limits};
    snprintf(scene->title, sizeof scene->title, "scene \"%s\"", name);
    return scene3d_generate(name, WIDTH, HEIGHT, &scene->scene);
}

// A scene with a name, its spheres mirrored along each axis, or not, and in another order.
static int roll_varied(TreeScene3D *scene, Random *random, const char *name, KdTreeLimits limits)
{
    const int result = roll_named(scene, name, limits);
    const float x = (float)random_sign(random), y = (float)random_sign(random),
                z = (float)random_sign(random);
    for (int i = 0; result == 0 && i < scene->scene.n_spheres; i++) {
        Sphere *sphere = &scene->scene.spheres[i];
        *sphere = (Sphere){x * sphere->x, y * sphere->y, z * sphere->z, sphere->radius};
    }
    if (result == 0) {
        scene3d_vary(&scene->scene, random);
    }
    return result;
}

// A generator's scene of this many spheres, from a seed of the job's.
static int roll_seeded(TreeScene3D *scene, Random *random, const char *kind, int n_spheres,
                       KdTreeLimits limits)
{
    char name[64];
    snprintf(name, sizeof name, "%s:n=%d,seed=%d", kind, n_spheres,
             (int)random_integer(random, 1, 1 << 30));
    return roll_named(scene, name, limits);
}

int roll_scenes_08(Random *random, Job08 *job)
{
    TreeScene3D *scenes = job->scenes;
    int result = roll_seeded(&scenes[0], random, "random", 120, (KdTreeLimits){12, 1});
    result |= roll_seeded(&scenes[1], random, "clusters", 140, (KdTreeLimits){14, 2});
    result |= roll_seeded(&scenes[2], random, "stadium", 120, (KdTreeLimits){16, 1});
    result |= roll_varied(&scenes[3], random, "one-cell", (KdTreeLimits){12, 1});
    result |= roll_varied(&scenes[4], random, "large-small", (KdTreeLimits){9, 4});
    result |= roll_varied(&scenes[5], random, "planes", (KdTreeLimits){8, 1});
    result |= roll_varied(&scenes[6], random, "coincident", (KdTreeLimits){7, 1});
    result |= roll_varied(&scenes[7], random, "one", (KdTreeLimits){4, 1});
    result |= roll_varied(&scenes[8], random, "none", (KdTreeLimits){4, 1});
    result |= roll_varied(&scenes[9], random, "lattice:n=4", (KdTreeLimits){9, 1});
    result |= roll_seeded(&scenes[10], random, "random", 100, (KdTreeLimits){3, 1});
    for (int k = 0; result == 0 && k < N_TREES; k++) {
        result = tree_expect_08(&scenes[k]);
    }
    return result;
}
