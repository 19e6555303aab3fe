// Molecules in XYZ files (see molecule.h).
//
// How many atoms, a comment, then an atom a line: its element, three coordinates in Angstrom, and
// what the program that wrote it thought fit. In extended XYZ the comment says which columns there
// are, each with a name, a type and a number of words: "Properties=species:S:1:mass:R:1:pos:R:3".
// Of a file with several frames, one after the other, the first is read. Read next: molecule_pdb.c.
#include "molecule.h"
#include "number.h"

#include <string.h>

#define PROPERTIES "Properties="
#define MAX_COLUMNS 64

// Where in a line an atom's words are, from 0.
typedef struct Columns {
    int element, point;  // the first of the point's three
    int n_words;         // that a line has at least
} Columns;

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

// What the comment says of an atom's columns; `columns` stays as it is where it says nothing.
static void columns_read(LineReader *lines, Columns *columns)
{
    static const char EXPECTED[] = "species:S:1 and pos:R:3 among its columns, "
                                   "at most " NUMBER_TEXT(MAX_COLUMNS) " in all";
    char *properties = strstr(lines->text, PROPERTIES);
    if (properties == NULL) {
        return;
    }
    properties += strlen(PROPERTIES);
    properties += *properties == '"';
    properties[strcspn(properties, "\" \t\r")] = '\0';
    char found[LINE_QUOTE_SIZE];
    line_quote(properties, found);
    int element = -1, point = -1, n_words = 0;
    for (char *rest = properties, *name; (name = strsep(&rest, ":")) != NULL;) {
        const char *type = strsep(&rest, ":");
        const char *text = strsep(&rest, ":");
        int64_t count;
        if (type == NULL || text == NULL ||
            number_read_integer(text, 1, MAX_COLUMNS, &count) != 0) {
            n_words = MAX_COLUMNS + 1;
            break;
        }
        if (count == 1 &&
            (strcmp(name, "species") == 0 || (strcmp(name, "Z") == 0 && element < 0))) {
            element = n_words;
        } else if (strcmp(name, "pos") == 0 && strcmp(type, "R") == 0 && count == 3) {
            point = n_words;
        }
        n_words += (int)count;
        if (n_words > MAX_COLUMNS) {
            break;
        }
    }
    if (element < 0 || point < 0 || n_words > MAX_COLUMNS) {
        line_fault(lines, PROPERTIES ": ", found, EXPECTED);
        return;
    }
    *columns = (Columns){element, point, n_words};
}

static void atom_read(Molecule *molecule, const Columns *columns)
{
    char *words[MAX_COLUMNS];
    char found[LINE_QUOTE_SIZE];
    const int n_words = line_split(molecule->lines.text, words, MAX_COLUMNS);
    if (n_words < columns->n_words) {
        snprintf(found, sizeof found, "%d word%s", n_words, n_words == 1 ? "" : "s");
        line_fault(&molecule->lines, "", found, "an element and its x, y and z");
        return;
    }
    const char *const *xyz = (const char *const *)words + columns->point;
    const char *element = words[columns->element];
    Vec3 point;
    point.x = molecule_read_coordinate(molecule, "x", xyz[0]);
    point.y = molecule_read_coordinate(molecule, "y", xyz[1]);
    point.z = molecule_read_coordinate(molecule, "z", xyz[2]);
    molecule_add_atom(molecule, point, element_read(element), element);
}

static int is_line(const char *line)
{
    (void)line;
    return 1;
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
            molecule->n_rest = 1;  // this one
            molecule_leave_out(molecule, "line", "of other frames", is_line);
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
    Columns columns = {.element = 0, .point = 1, .n_words = 4};
    if (!lines->failed) {
        if (line_read_start(lines, PROPERTIES)) {
            columns_read(lines, &columns);
        } else {
            line_fault(lines, "", "the end of the file", "a comment, which may be empty");
        }
    }
    for (int i = 0; i < n_atoms && !lines->failed; i++) {
        if (line_read(lines)) {
            atom_read(&molecule, &columns);
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
