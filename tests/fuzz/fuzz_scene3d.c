// Any bytes as a file of a 3D scene: the readers must take them or refuse them, not fall over.
//
// libFuzzer calls LLVMFuzzerTestOneInput() with bytes that it varies towards new branches of the
// code (README.md here says how); tests/unit/test_corpus.c calls it with the bytes that did so
// before. The first byte chooses the reader: 'p' PDB, 'x' XYZ, anything else NFF. What was read is
// checked, written as NFF, and must be the same when it is read again.
// Flow: SCENE -> buffers -> kernel -> image -> comparison. Read next: common/scene3d.h.
#include "scene3d.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t n_bytes);

// Stop at once when what should hold does not. The sanitizers, and libFuzzer, then show the input.
#define MUST_HOLD(condition)                                                                       \
    do {                                                                                           \
        if (!(condition)) {                                                                        \
            fprintf(stdout, "%s:%d: does not hold: %s\n", __FILE__, __LINE__, #condition);         \
            fflush(stdout);                                                                        \
            abort();                                                                               \
        }                                                                                          \
    } while (0)

typedef int Read(FILE *file, const char *name, Scene3D *scene);

// Call a reader. A failure must leave one line on stderr, a success none or one warning, and the
// line nothing that moves a terminal. Returns what the reader returns.
static int read_quietly(Read *read, FILE *file, Scene3D *scene)
{
    FILE *real_stderr = stderr;
    char *message = NULL;
    size_t length = 0;
    stderr = open_memstream(&message, &length);  // glibc's stderr is a variable
    MUST_HOLD(stderr != NULL);
    const int result = read(file, "input", scene);
    fclose(stderr);
    stderr = real_stderr;

    MUST_HOLD(result == 0 || result == -1);
    MUST_HOLD(result == 0 || length > 0);
    for (size_t i = 0; i < length; i++) {
        MUST_HOLD(i + 1 == length ? message[i] == '\n' : message[i] >= ' ' && message[i] < 0x7f);
    }
    MUST_HOLD(length == 0 || strncmp(message, "input:", 6) == 0);
    MUST_HOLD(length == 0 || (strncmp(message, "input: warning: ", 16) == 0) == (result == 0));
    free(message);
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
    MUST_HOLD(file != NULL && scene3d_write_nff(file, scene) == 0);
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
