// Texts of molecules, and reading them, for the tests of the readers of PDB and XYZ files.
#ifndef UNIT_MOLECULE_SAMPLES_H
#define UNIT_MOLECULE_SAMPLES_H

#define SCENE_NAME "molecule"
#include "elements.h"
#include "molecule.h"
#include "scene_texts.h"

#include <math.h>

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
