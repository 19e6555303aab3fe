// The chemical elements up to einsteinium (see elements.h).
//
// Read next: molecule.c.
//
// Radii: nonmetals by A. Bondi, "van der Waals Volumes and Radii", J. Phys. Chem. 68 (1964) 441;
// the rest of the main groups by M. Mantina et al., J. Phys. Chem. A 113 (2009) 5806; transition
// metals, lanthanides and actinides by S. Alvarez, Dalton Trans. 42 (2013) 8617. Nobody measured
// promethium.
// Colours: Corey, Pauling and Koltun painted wooden balls, carbon black and oxygen red; these are
// the shades that the program Jmol made of them.
#include "elements.h"

#include <stddef.h>

const Element ELEMENT_UNKNOWN = {"", ELEMENT_UNKNOWN_RADIUS, 0xFF69B4};

// In the order of their atomic numbers, from 1.
static const Element ELEMENTS[] = {
    {"H", 1.20f, 0xFFFFFF},
    {"He", 1.40f, 0xD9FFFF},
    {"Li", 1.81f, 0xCC80FF},
    {"Be", 1.53f, 0xC2FF00},
    {"B", 1.92f, 0xFFB5B5},
    {"C", 1.70f, 0x909090},
    {"N", 1.55f, 0x3050F8},
    {"O", 1.52f, 0xFF0D0D},
    {"F", 1.47f, 0x90E050},
    {"Ne", 1.54f, 0xB3E3F5},
    {"Na", 2.27f, 0xAB5CF2},
    {"Mg", 1.73f, 0x8AFF00},
    {"Al", 1.84f, 0xBFA6A6},
    {"Si", 2.10f, 0xF0C8A0},
    {"P", 1.80f, 0xFF8000},
    {"S", 1.80f, 0xFFFF30},
    {"Cl", 1.75f, 0x1FF01F},
    {"Ar", 1.88f, 0x80D1E3},
    {"K", 2.75f, 0x8F40D4},
    {"Ca", 2.31f, 0x3DFF00},
    {"Sc", 2.58f, 0xE6E6E6},
    {"Ti", 2.46f, 0xBFC2C7},
    {"V", 2.42f, 0xA6A6AB},
    {"Cr", 2.45f, 0x8A99C7},
    {"Mn", 2.45f, 0x9C7AC7},
    {"Fe", 2.44f, 0xE06633},
    {"Co", 2.40f, 0xF090A0},
    {"Ni", 2.40f, 0x50D050},
    {"Cu", 2.38f, 0xC88033},
    {"Zn", 2.39f, 0x7D80B0},
    {"Ga", 1.87f, 0xC28F8F},
    {"Ge", 2.11f, 0x668F8F},
    {"As", 1.85f, 0xBD80E3},
    {"Se", 1.90f, 0xFFA100},
    {"Br", 1.85f, 0xA62929},
    {"Kr", 2.02f, 0x5CB8D1},
    {"Rb", 3.03f, 0x702EB0},
    {"Sr", 2.49f, 0x00FF00},
    {"Y", 2.75f, 0x94FFFF},
    {"Zr", 2.52f, 0x94E0E0},
    {"Nb", 2.56f, 0x73C2C9},
    {"Mo", 2.45f, 0x54B5B5},
    {"Tc", 2.44f, 0x3B9E9E},
    {"Ru", 2.46f, 0x248F8F},
    {"Rh", 2.44f, 0x0A7D8C},
    {"Pd", 2.15f, 0x006985},
    {"Ag", 2.53f, 0xC0C0C0},
    {"Cd", 2.49f, 0xFFD98F},
    {"In", 1.93f, 0xA67573},
    {"Sn", 2.17f, 0x668080},
    {"Sb", 2.06f, 0x9E63B5},
    {"Te", 2.06f, 0xD47A00},
    {"I", 1.98f, 0x940094},
    {"Xe", 2.16f, 0x429EB0},
    {"Cs", 3.43f, 0x57178F},
    {"Ba", 2.68f, 0x00C900},
    {"La", 2.98f, 0x70D4FF},
    {"Ce", 2.88f, 0xFFFFC7},
    {"Pr", 2.92f, 0xD9FFC7},
    {"Nd", 2.95f, 0xC7FFC7},
    {"Pm", ELEMENT_UNKNOWN_RADIUS, 0xA3FFC7},
    {"Sm", 2.90f, 0x8FFFC7},
    {"Eu", 2.87f, 0x61FFC7},
    {"Gd", 2.83f, 0x45FFC7},
    {"Tb", 2.79f, 0x30FFC7},
    {"Dy", 2.87f, 0x1FFFC7},
    {"Ho", 2.81f, 0x00FF9C},
    {"Er", 2.83f, 0x00E675},
    {"Tm", 2.79f, 0x00D452},
    {"Yb", 2.80f, 0x00BF38},
    {"Lu", 2.74f, 0x00AB24},
    {"Hf", 2.63f, 0x4DC2FF},
    {"Ta", 2.53f, 0x4DA6FF},
    {"W", 2.57f, 0x2194D6},
    {"Re", 2.49f, 0x267DAB},
    {"Os", 2.48f, 0x266696},
    {"Ir", 2.41f, 0x175487},
    {"Pt", 2.29f, 0xD0D0E0},
    {"Au", 2.32f, 0xFFD123},
    {"Hg", 2.45f, 0xB8B8D0},
    {"Tl", 1.96f, 0xA6544D},
    {"Pb", 2.02f, 0x575961},
    {"Bi", 2.07f, 0x9E4FB5},
    {"Po", 1.97f, 0xAB5C00},
    {"At", 2.02f, 0x754F45},
    {"Rn", 2.20f, 0x428296},
    {"Fr", 3.48f, 0x420066},
    {"Ra", 2.83f, 0x007D00},
    {"Ac", 2.80f, 0x70ABFA},
    {"Th", 2.93f, 0x00BAFF},
    {"Pa", 2.88f, 0x00A1FF},
    {"U", 2.71f, 0x008FFF},
    {"Np", 2.82f, 0x0080FF},
    {"Pu", 2.81f, 0x006BFF},
    {"Am", 2.83f, 0x545CF2},
    {"Cm", 3.05f, 0x785CE3},
    {"Bk", 3.40f, 0x8A4FE3},
    {"Cf", 3.05f, 0xA136D4},
    {"Es", 2.70f, 0xB31FD4},
};
enum { N_ELEMENTS = sizeof ELEMENTS / sizeof ELEMENTS[0] };

static int is_letter(char c)
{
    return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z');
}

// Does the text begin with this symbol, and no letter follow? The locale plays no part, as it would
// in strncasecmp(): in Turkish "I" and "i" are different letters.
static int begins_with(const char *text, const char *symbol)
{
    // ASCII: 32 is what a small letter has and its capital has not.
    while (*symbol != '\0' && is_letter(*text) && (*symbol | 32) == (*text | 32)) {
        symbol++;
        text++;
    }
    return *symbol == '\0' && !is_letter(*text);
}

const Element *element_by_symbol(const char *text)
{
    // Deuterium has a symbol of its own in neutron structures.
    if (begins_with(text, "D")) {
        return &ELEMENTS[0];
    }
    for (int i = 0; i < N_ELEMENTS; i++) {
        if (begins_with(text, ELEMENTS[i].symbol)) {
            return &ELEMENTS[i];
        }
    }
    return NULL;
}

const Element *element_by_number(int64_t atomic_number)
{
    return atomic_number >= 1 && atomic_number <= N_ELEMENTS ? &ELEMENTS[atomic_number - 1] : NULL;
}
