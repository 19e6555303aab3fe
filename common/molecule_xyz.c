// Molecules in XYZ files (scene3d_read_xyz() of scene3d.h).
//
// How many atoms, a comment, then an atom a line: its element, three coordinates in Angstrom, and
// what the program that wrote it thought fit. Of a file with several frames, one after the other,
// the first is read. Read next: molecule_pdb.c.
#include "molecule.h"
#include "number.h"

// Read how many atoms there are. Returns it, or 0 after a complaint.
static int count_read(Molecule *molecule)
{
    static const char EXPECTED[] =
        "the number of atoms, from 1 to " NUMBER_TEXT(SCENE3D_MAX_SPHERES);
    LineReader *lines = &molecule->lines;
    char *word;
    int64_t n_atoms = 0;
    char found[LINE_QUOTE_SIZE];
    if (!line_read(lines)) {
        line_fault(lines, "", "the end of the file", EXPECTED);
        return 0;
    }
    const int n_words = line_split(lines->text, &word, 1);
    if (n_words != 1) {
        snprintf(found, sizeof found, "%d words", n_words);
        line_fault(lines, "", found, EXPECTED);
    } else if (number_read_integer(word, 1, SCENE3D_MAX_SPHERES, &n_atoms) != 0) {
        line_fault(lines, "", line_quote(word, found), EXPECTED);
    }
    return (int)n_atoms;
}

// "C" or "6".
static const Element *element_read(const char *word)
{
    int64_t atomic_number;
    if (number_read_integer(word, 0, INT64_MAX, &atomic_number) == 0) {
        return element_by_number(atomic_number);
    }
    return element_by_symbol(word);
}

static void atom_read(Molecule *molecule)
{
    char *words[4];
    char found[LINE_QUOTE_SIZE];
    const int n_words = line_split(molecule->lines.text, words, 4);
    if (n_words < 4) {
        snprintf(found, sizeof found, "%d word%s", n_words, n_words == 1 ? "" : "s");
        line_fault(&molecule->lines, "", found, "an element and its x, y and z");
        return;
    }
    Vec3 point;
    point.x = molecule_read_coordinate(molecule, "x", words[1]);
    point.y = molecule_read_coordinate(molecule, "y", words[2]);
    point.z = molecule_read_coordinate(molecule, "z", words[3]);
    molecule_add_atom(molecule, point, element_read(words[0]), words[0]);
}

// After the last atom comes nothing, or the next frame, which begins with a number of its own. An
// atom more than the first line says is a mistake somewhere.
static void end_check(Molecule *molecule)
{
    char *word;
    int64_t number;
    while (line_read(&molecule->lines)) {
        const int n_words = line_split(molecule->lines.text, &word, 1);
        if (n_words == 1 && number_read_integer(word, 0, INT64_MAX, &number) == 0) {
            return;
        }
        if (n_words > 0) {
            char found[LINE_QUOTE_SIZE], expected[64];
            snprintf(expected, sizeof expected, "no more atoms than line 1 says, %d",
                     molecule->builder.scene.n_spheres);
            line_fault(&molecule->lines, "", line_quote(word, found), expected);
            return;
        }
    }
}

int scene3d_read_xyz(FILE *file, const char *name, Scene3D *scene)
{
    Molecule molecule;
    molecule_begin(&molecule, file, name);
    LineReader *lines = &molecule.lines;
    const int n_atoms = count_read(&molecule);
    if (!lines->failed && !line_read(lines)) {
        line_fault(lines, "", "the end of the file", "a comment, which may be empty");
    }
    for (int i = 0; i < n_atoms && !lines->failed; i++) {
        if (line_read(lines)) {
            atom_read(&molecule);
        } else {
            char found[64], expected[32];
            snprintf(found, sizeof found, "the end of the file after %d atom%s", i,
                     i == 1 ? "" : "s");
            snprintf(expected, sizeof expected, "%d", n_atoms);
            line_fault(lines, "", found, expected);
        }
    }
    if (!lines->failed) {
        end_check(&molecule);
    }
    return molecule_finish(&molecule, scene);
}
