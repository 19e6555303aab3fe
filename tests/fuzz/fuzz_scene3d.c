// Any bytes as a file of a 3D scene: the readers must take them or refuse them, not fall over.
//
// The first byte chooses the reader: 'p' PDB, 'x' XYZ, anything else NFF. What was read is checked,
// written as NFF, and must be the same when it is read again.
// Read next: common/scene3d.h.
#include "fuzz.h"

#include "molecule.h"
#include "nff_text.h"
#include "scene3d_nff.h"

#include <math.h>

typedef int Read(FILE *file, const char *name, Scene3D *scene);

// Call a reader. A failure must leave one line on stderr, a success none or one warning. Returns
// what the reader returns.
static int read_quietly(Read *read, FILE *file, Scene3D *scene)
{
    Messages messages;
    messages_begin(&messages);
    const int result = read(file, "input", scene);
    messages_end(&messages);
    const char *text = messages.text;
    const size_t length = messages.length;

    MUST_HOLD(result == 0 || result == -1);
    MUST_HOLD(result == 0 || length > 0);
    MUST_HOLD(length == 0 || strncmp(text, "input:", 6) == 0);
    MUST_HOLD(length == 0 || (strncmp(text, "input: warning: ", 16) == 0) == (result == 0));
    free(messages.text);
    return result;
}

// All numbers of a structure that holds floats only.
static int are_finite(const void *numbers, size_t n_bytes)
{
    for (size_t i = 0; i < n_bytes / sizeof(float); i++) {
        float number;
        memcpy(&number, (const char *)numbers + i * sizeof number, sizeof number);
        if (!isfinite(number)) {
            return 0;
        }
    }
    return 1;
}

static void check_scene(const Scene3D *scene)
{
    MUST_HOLD((scene->n_spheres == 0) == (scene->spheres == NULL));
    MUST_HOLD(are_finite(&scene->view, sizeof scene->view));
    MUST_HOLD(are_finite(&scene->background, sizeof scene->background));
    MUST_HOLD(are_finite(scene->lights, (size_t)scene->n_lights * sizeof *scene->lights));
    MUST_HOLD(are_finite(scene->materials, (size_t)scene->n_materials * sizeof(Material)));
    MUST_HOLD(are_finite(scene->spheres, (size_t)scene->n_spheres * sizeof(Sphere)));
    for (int i = 0; i < scene->n_spheres; i++) {
        MUST_HOLD(scene->spheres[i].radius != 0);
        MUST_HOLD(scene->material_ids[i] < (u32)scene->n_materials);
    }
    MUST_HOLD(scene3d_view_fault(&scene->view) == NULL);
    MUST_HOLD(scene->view.angle > 0 && scene->view.angle < 180);
    MUST_HOLD(scene->width >= 1 && scene->height >= 1);
}

static int is_same(const void *a, const void *b, int n_entries, size_t entry_size)
{
    return n_entries == 0 || memcmp(a, b, (size_t)n_entries * entry_size) == 0;
}

static void check_same(const Scene3D *a, const Scene3D *b)
{
    MUST_HOLD(a->n_spheres == b->n_spheres);
    MUST_HOLD(a->n_materials == b->n_materials);
    MUST_HOLD(a->n_lights == b->n_lights);
    MUST_HOLD(is_same(a->spheres, b->spheres, a->n_spheres, sizeof(Sphere)));
    MUST_HOLD(is_same(a->material_ids, b->material_ids, a->n_spheres, sizeof(u32)));
    MUST_HOLD(is_same(a->materials, b->materials, a->n_materials, sizeof(Material)));
    MUST_HOLD(is_same(a->lights, b->lights, a->n_lights, sizeof(Light)));
    MUST_HOLD(is_same(&a->background, &b->background, 1, sizeof a->background));
    MUST_HOLD(is_same(&a->view, &b->view, 1, sizeof a->view));
    MUST_HOLD(a->width == b->width && a->height == b->height);
}

// Write the scene, read it again, compare.
static void check_round_trip(const Scene3D *scene)
{
    char *text = NULL;
    size_t length = 0;
    FILE *file = open_memstream(&text, &length);
    MUST_HOLD(file != NULL);
    nff_write(file, scene);
    fclose(file);
    file = fmemopen(text, length, "rb");
    MUST_HOLD(file != NULL);
    Scene3D again;
    MUST_HOLD(read_quietly(scene3d_read_nff, file, &again) == 0);
    fclose(file);
    check_same(scene, &again);
    scene3d_free(&again);
    free(text);
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t n_bytes)
{
    if (n_bytes < 2) {
        return 0;  // fmemopen() wants a byte
    }
    Read *read = bytes[0] == 'p'   ? scene3d_read_pdb
                 : bytes[0] == 'x' ? scene3d_read_xyz
                                   : scene3d_read_nff;
    FILE *file = fmemopen((void *)(uintptr_t)(bytes + 1), n_bytes - 1, "rb");
    MUST_HOLD(file != NULL);
    Scene3D scene;
    const int result = read_quietly(read, file, &scene);
    fclose(file);
    if (result == 0) {
        check_scene(&scene);
        check_round_trip(&scene);
        scene3d_free(&scene);
    }
    return 0;
}
