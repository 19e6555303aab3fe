// A 3D scene while a file is read (see scene3d_builder.h).
//
// What a file says about its own size is not believed: arrays grow with what was read. Read next:
// scene3d_nff.c.
#include "scene3d_builder.h"

#include "number.h"

#include <stdlib.h>
#include <string.h>

static void report_memory(Scene3DBuilder *builder)
{
    line_fault(builder->reader, "", "no memory", "a smaller scene");
}

// The array with room for one entry more. Its length doubles whenever n_entries is a power of two,
// so nobody has to remember it. Returns NULL after a complaint; the old array is then as it was.
static void *array_grow(Scene3DBuilder *builder, void *array, int n_entries, size_t entry_size)
{
    if ((n_entries & (n_entries - 1)) != 0) {
        return array;
    }
    void *grown = realloc(array, (n_entries == 0 ? 1 : 2 * (size_t)n_entries) * entry_size);
    if (grown == NULL) {
        report_memory(builder);
    }
    return grown;
}

// ---- Materials ----------------------------------------------------------------------------------

// The slot of an equal material, or the free one where it belongs. FNV-1a hash, linear probing.
static u32 *slot_find(Scene3DBuilder *builder, const Material *material)
{
    const unsigned char *bytes = (const unsigned char *)material;
    u32 hash = 2166136261u;
    for (size_t i = 0; i < sizeof *material; i++) {
        hash = (hash ^ bytes[i]) * 16777619u;
    }
    for (u32 i = hash;; i++) {
        u32 *slot = &builder->material_table[i & (builder->n_material_slots - 1)];
        if (*slot == 0 ||
            memcmp(&builder->scene.materials[*slot - 1], material, sizeof *material) == 0) {
            return slot;
        }
    }
}

// See that at least half of the slots stay free. Returns 0, or -1 after a complaint.
static int table_grow(Scene3DBuilder *builder)
{
    const Scene3D *scene = &builder->scene;
    if (2 * ((u32)scene->n_materials + 1) <= builder->n_material_slots) {
        return 0;
    }
    const u32 n_slots = builder->n_material_slots == 0 ? 64 : 2 * builder->n_material_slots;
    u32 *table = calloc(n_slots, sizeof *table);
    if (table == NULL) {
        report_memory(builder);
        return -1;
    }
    free(builder->material_table);
    builder->material_table = table;
    builder->n_material_slots = n_slots;
    for (int i = 0; i < scene->n_materials; i++) {
        *slot_find(builder, &scene->materials[i]) = (u32)i + 1;
    }
    return 0;
}

u32 builder_add_material(Scene3DBuilder *builder, const Material *material)
{
    Scene3D *scene = &builder->scene;
    if (table_grow(builder) != 0) {
        return 0;
    }
    u32 *slot = slot_find(builder, material);
    if (*slot != 0) {
        return *slot - 1;
    }
    if (scene->n_materials == SCENE3D_MAX_SPHERES) {
        line_fault(builder->reader, "", "more materials",
                   "at most " NUMBER_TEXT(SCENE3D_MAX_SPHERES));
        return 0;
    }
    Material *materials =
        array_grow(builder, scene->materials, scene->n_materials, sizeof *materials);
    if (materials == NULL) {
        return 0;
    }
    scene->materials = materials;
    scene->materials[scene->n_materials++] = *material;
    *slot = (u32)scene->n_materials;
    return *slot - 1;
}

// ---- Spheres and lights -------------------------------------------------------------------------

void builder_add_sphere(Scene3DBuilder *builder, Sphere sphere, u32 material_id)
{
    Scene3D *scene = &builder->scene;
    if (scene->n_spheres == SCENE3D_MAX_SPHERES) {
        line_fault(builder->reader, "", "more spheres",
                   "at most " NUMBER_TEXT(SCENE3D_MAX_SPHERES));
        return;
    }
    Sphere *spheres = array_grow(builder, scene->spheres, scene->n_spheres, sizeof *spheres);
    if (spheres == NULL) {
        return;
    }
    scene->spheres = spheres;
    u32 *ids = array_grow(builder, scene->material_ids, scene->n_spheres, sizeof *ids);
    if (ids == NULL) {
        return;
    }
    scene->material_ids = ids;
    scene->spheres[scene->n_spheres] = sphere;
    scene->material_ids[scene->n_spheres++] = material_id;
}

void builder_add_light(Scene3DBuilder *builder, Light light)
{
    Scene3D *scene = &builder->scene;
    if (scene->n_lights == SCENE3D_MAX_LIGHTS) {
        line_fault(builder->reader, "", "more lights", "at most " NUMBER_TEXT(SCENE3D_MAX_LIGHTS));
        return;
    }
    Light *lights = array_grow(builder, scene->lights, scene->n_lights, sizeof *lights);
    if (lights == NULL) {
        return;
    }
    scene->lights = lights;
    scene->lights[scene->n_lights++] = light;
}

int builder_finish(Scene3DBuilder *builder, Scene3D *scene)
{
    free(builder->material_table);
    if (builder->reader->failed) {
        scene3d_free(&builder->scene);
        return -1;
    }
    *scene = builder->scene;
    return 0;
}
