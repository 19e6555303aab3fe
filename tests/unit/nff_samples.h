// Texts in the Neutral File Format, and reading them, for the tests of its reader.
#ifndef UNIT_NFF_SAMPLES_H
#define UNIT_NFF_SAMPLES_H

#include "scene3d_nff.h"
#include "surroundings.h"

// Text with its length, so that it may hold NUL bytes.
#define TEXT(literal) literal, sizeof(literal) - 1

#define VIEW "v\nfrom 0 0 5\nat 0 0 0\nup 0 1 0\nangle 45\nhither 1\nresolution 512 256\n"
#define SPHERE "s 1 -2.5 3 0.5\n"

static inline int read_text(const char *text, size_t length, Scene3D *scene)
{
    *scene = (Scene3D){0};
    FILE *file = tmpfile();
    fwrite(text, 1, length, file);
    rewind(file);
    int result = scene3d_read_nff(file, "scene.nff", scene);
    fclose(file);
    return result;
}

// Read text that is good and that nobody is warned of.
static inline Scene3D read_good(const char *text)
{
    Scene3D scene;
    capture_begin(2);
    int result = read_text(text, strlen(text), &scene);
    const char *message = capture_end(2);
    cr_assert_eq(result, 0, "%s", message);
    cr_expect_str_eq(message, "");
    return scene;
}

static inline int are_equal(Vec3 v, float x, float y, float z)
{
    return v.x == x && v.y == y && v.z == z;
}

#endif
