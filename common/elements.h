// The chemical elements, as pictures of molecules show them: how large an atom is, and its colour.
//
// Read next: molecule.h.
#ifndef COMMON_ELEMENTS_H
#define COMMON_ELEMENTS_H

#include <stdint.h>

typedef struct Element {
    const char *symbol;
    float radius;    // van der Waals radius, Angstrom
    uint32_t color;  // 0xRRGGBB
} Element;

// What is drawn for an atom of an unknown element: pink, and of a radius that some atom could have.
#define ELEMENT_UNKNOWN_RADIUS 1.5f
extern const Element ELEMENT_UNKNOWN;

// The element whose symbol this text begins with, in any case: "Cl", "CL", "cl", and "Cl1" or
// "Cl_a", as some programs number their atoms; "Clx" is none. "D" is hydrogen. Returns NULL for an
// unknown one.
const Element *element_by_symbol(const char *text);

// The element with this atomic number: 1 is hydrogen. Returns NULL for an unknown one.
const Element *element_by_number(int64_t atomic_number);

#endif
