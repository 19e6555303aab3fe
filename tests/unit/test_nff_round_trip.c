// common/scene3d_nff: a scene of any numbers, written as text, reads back to the same bits; a large
// one is read in seconds.
#include "nff_samples.h"
#include "nff_text.h"
#include "random.h"

#include <limits.h>
#include <math.h>

TestSuite(nff_round_trip, .init = folder_enter, .fini = folder_leave);

// Any finite float, of any size.
static float random_float(Random *random)
{
    float number;
    do {
        uint32_t bits = (uint32_t)random_bits(random);
        memcpy(&number, &bits, sizeof number);
    } while (!isfinite(number));
    return number;
}

static float random_positive(Random *random)
{
    return fabsf(random_float(random));
}

// A length that a view can have.
static float random_length(Random *random)
{
    return fminf(fmaxf(random_positive(random), 1e-30f), 1e30f);
}

static float random_share(Random *random)
{
    return (float)random_integer(random, 0, INT_MAX) / (float)INT_MAX;
}

static Vec3 random_color(Random *random)
{
    return (Vec3){random_share(random), random_share(random), random_share(random)};
}

static Vec3 random_point(Random *random)
{
    return (Vec3){random_float(random), random_float(random), random_float(random)};
}

// A coordinate, or a radius, that a sphere can have.
static float random_size(Random *random)
{
    float size;
    do {
        size = random_float(random);
    } while (fabsf(size) < (float)SCENE3D_SMALLEST || fabsf(size) > (float)SCENE3D_LARGEST);
    return size;
}

// The most spheres, materials and lights of a scene.
#define MAX_ENTRIES 40

// Where a random scene's arrays lie. Its materials differ, and are used in any order or not at all.
typedef struct Room {
    Sphere spheres[MAX_ENTRIES];
    u32 material_ids[MAX_ENTRIES];
    Material materials[MAX_ENTRIES];
    Light lights[MAX_ENTRIES];
} Room;

static Scene3D random_scene(Random *random, Room *room)
{
    Scene3D scene = {
        .spheres = room->spheres,
        .material_ids = room->material_ids,
        .materials = room->materials,
        .lights = room->lights,
        .n_spheres = (int)random_integer(random, 0, MAX_ENTRIES),
        .n_materials = (int)random_integer(random, 1, MAX_ENTRIES),
        .n_lights = (int)random_integer(random, 0, MAX_ENTRIES),
        .background = random_color(random),
        .view = {{0, 0, fabsf(random_size(random))},
                 {0, 0, 0},
                 {0, random_length(random), 0},
                 179 * random_share(random) + 1e-6f,
                 random_positive(random)},
        .width = (int)random_integer(random, 1, 1000000),
        .height = (int)random_integer(random, 1, 1000000),
    };
    for (int i = 0; i < scene.n_spheres; i++) {
        room->spheres[i] =
            (Sphere){i % 5 == 0 ? -1e-45f : random_size(random), random_size(random),
                     random_size(random), i % 5 == 0 ? -1e-18f : random_size(random)};
        room->material_ids[i] = (u32)random_integer(random, 0, scene.n_materials - 1);
    }
    for (int i = 0; i < scene.n_materials; i++) {
        room->materials[i] = (Material){random_color(random),    random_positive(random),
                                        random_positive(random), (float)i,
                                        random_share(random),    random_positive(random)};
    }
    for (int i = 0; i < scene.n_lights; i++) {
        room->lights[i] = (Light){random_point(random), random_color(random)};
    }
    return scene;
}

static int arrays_are_equal(const void *a, const void *b, int n_entries, size_t entry_size)
{
    return n_entries == 0 || memcmp(a, b, (size_t)n_entries * entry_size) == 0;
}

static void expect_same(const Scene3D *a, const Scene3D *b)
{
    cr_assert(a->n_spheres == b->n_spheres && a->n_materials == b->n_materials &&
              a->n_lights == b->n_lights);
    cr_expect(arrays_are_equal(a->spheres, b->spheres, a->n_spheres, sizeof(Sphere)));
    cr_expect(arrays_are_equal(a->material_ids, b->material_ids, a->n_spheres, sizeof(u32)));
    cr_expect(arrays_are_equal(a->materials, b->materials, a->n_materials, sizeof(Material)));
    cr_expect(arrays_are_equal(a->lights, b->lights, a->n_lights, sizeof(Light)));
    cr_expect_eq(memcmp(&a->background, &b->background, sizeof a->background), 0);
    cr_expect_eq(memcmp(&a->view, &b->view, sizeof a->view), 0);
    cr_expect(a->width == b->width && a->height == b->height);
}

Test(nff_round_trip, what_is_written_reads_back_to_the_bit)
{
    Random random = {1};
    for (int round = 0; round < 500; round++) {
        Room room;
        const Scene3D scene = random_scene(&random, &room);
        FILE *file = tmpfile();
        nff_write(file, &scene);
        rewind(file);
        Scene3D again;
        cr_assert_eq(scene3d_read_nff(file, "again.nff", &again), 0, "round %d", round);
        fclose(file);
        expect_same(&scene, &again);
        scene3d_free(&again);
    }
}

Test(nff_round_trip, a_million_spheres_take_seconds)
{
    FILE *file = tmpfile();
    fputs(VIEW, file);
    for (int i = 0; i < 1000000; i++) {
        fprintf(file, "s %d.0625 12.5 3.25 0.5\n", i % 1000);
    }
    rewind(file);
    Scene3D scene;
    cr_assert_eq(scene3d_read_nff(file, "scene.nff", &scene), 0);
    fclose(file);
    cr_expect_eq(scene.n_spheres, 1000000);
    scene3d_free(&scene);
}
