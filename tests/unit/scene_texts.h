// Reading scenes from texts, for the tests of their readers: nff_samples.h and molecule_samples.h,
// which say before what their files are called (SCENE_NAME).
#ifndef UNIT_SCENE_TEXTS_H
#define UNIT_SCENE_TEXTS_H

#include "scene3d.h"
#include "surroundings.h"

// Text with its length, so that it may hold NUL bytes.
#define TEXT(literal) literal, sizeof(literal) - 1

typedef int Read(FILE *file, const char *name, Scene3D *scene);

static inline int read_text(Read *read, const char *text, size_t length, Scene3D *scene)
{
    *scene = (Scene3D){0};
    FILE *file = tmpfile();
    fwrite(text, 1, length, file);
    rewind(file);
    int result = read(file, SCENE_NAME, scene);
    fclose(file);
    return result;
}

// Read text that is good, and expect this warning, or "".
static inline Scene3D read_good(Read *read, const char *text, const char *warning)
{
    Scene3D scene;
    capture_begin(2);
    int result = read_text(read, text, strlen(text), &scene);
    const char *message = capture_end(2);
    cr_assert_eq(result, 0, "%s", message);
    cr_expect_str_eq(message, warning);
    return scene;
}

static inline void expect_fault(Read *read, const char *text, size_t length, const char *fault)
{
    Scene3D scene;
    char expected[256];
    capture_begin(2);
    int result = read_text(read, text, length, &scene);
    const char *message = capture_end(2);
    snprintf(expected, sizeof expected, SCENE_NAME ":%s\n", fault);
    cr_expect_str_eq(message, expected);
    cr_expect_eq(result, -1, "was read: %s", fault);
    cr_expect_null(scene.spheres);
}

// Wherever a file stops there is a scene or one message. Returns how often there is a scene.
static inline int expect_cut_anywhere(Read *read, const char *text)
{
    int n_read = 0;
    for (size_t length = 0; length <= strlen(text); length++) {
        Scene3D scene;
        capture_begin(2);
        int result = read_text(read, text, length, &scene);
        const char *message = capture_end(2);
        if (result != 0 || message[0] != '\0') {
            expect_one_message(message, result == 0 ? SCENE_NAME ": warning: " : SCENE_NAME ":");
        }
        n_read += result == 0;
        scene3d_free(&scene);
    }
    return n_read;
}

#endif
