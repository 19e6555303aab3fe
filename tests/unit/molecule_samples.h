// Texts of molecules, and reading them, for the tests of the readers of PDB and XYZ files.
#ifndef UNIT_MOLECULE_SAMPLES_H
#define UNIT_MOLECULE_SAMPLES_H

#include "elements.h"
#include "molecule.h"
#include "surroundings.h"

#include <math.h>

// Text with its length, so that it may hold NUL bytes.
#define TEXT(literal) literal, sizeof(literal) - 1

typedef int Read(FILE *file, const char *name, Scene3D *scene);

static inline int read_text(Read *read, const char *text, size_t length, Scene3D *scene)
{
    *scene = (Scene3D){0};
    FILE *file = tmpfile();
    fwrite(text, 1, length, file);
    rewind(file);
    int result = read(file, "molecule", scene);
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
    snprintf(expected, sizeof expected, "molecule:%s\n", fault);
    cr_expect_str_eq(message, expected);
    cr_expect_eq(result, -1, "was read: %s", fault);
    cr_expect_null(scene.spheres);
}

static inline void expect_atom(const Scene3D *scene, int i, float x, float y, float z,
                               const char *symbol)
{
    const Element *element = symbol == NULL ? &ELEMENT_UNKNOWN : element_by_symbol(symbol);
    const Sphere *atom = &scene->spheres[i];
    const Vec3 color = scene->materials[scene->material_ids[i]].color;
    cr_expect(atom->x == x && atom->y == y && atom->z == z, "atom %d is at %g %g %g", i,
              (double)atom->x, (double)atom->y, (double)atom->z);
    cr_expect_eq(atom->radius, element->radius, "atom %d: radius %g", i, (double)atom->radius);
    cr_expect_eq((uint32_t)lrintf(255 * color.x) << 16 | (uint32_t)lrintf(255 * color.y) << 8 |
                     (uint32_t)lrintf(255 * color.z),
                 element->color, "atom %d has another colour", i);
}

// An atom of a PDB file; above it the numbers of the columns.
//             1234567890123456789012345678901234567890123456789012345678901234567890123456789
#define CA_ATOM "ATOM      2  CA  ALA A   1      -1.000   2.500   3.000  1.00  0.00           C\n"

#endif
