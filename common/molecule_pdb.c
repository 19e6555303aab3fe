// Molecules in files of the Protein Data Bank (scene3d_read_pdb() of scene3d.h).
//
// Flow: SCENE -> buffers -> kernel -> image -> comparison. A line is a record; its first six
// columns say which. Everything stands in fixed columns, as on punched cards, often without a blank
// between. Atoms are read, everything else is passed over. Read next: molecule.c.
//
// Source: wwPDB, "Protein Data Bank Contents Guide: Atomic Coordinate Entry Format", version 3.3,
// 2012, sections ATOM, HETATM and MODEL.
#include "molecule.h"

#include <string.h>

// The widest field that is read, and its NUL.
#define FIELD_SIZE 9

typedef struct PdbReader {
    Molecule molecule;
    char residue[FIELD_SIZE];  // the one whose atoms are being read
    char location;             // which of its alternate locations is taken; blank until one is met
} PdbReader;

// The text in some columns of the current line, which count from 1, without the blanks around it;
// "" where the line is too short.
static const char *field_read(const PdbReader *reader, int first, int last, char *field)
{
    const char *line = reader->molecule.lines.text;
    const int length = (int)strcspn(line, "\r");
    last = last < length ? last : length;
    while (first <= last && line[first - 1] == ' ') {
        first++;
    }
    while (last >= first && line[last - 1] == ' ') {
        last--;
    }
    const size_t n = last < first ? 0 : (size_t)(last - first + 1);
    if (n > 0) {
        memcpy(field, line + first - 1, n);
    }
    field[n] = '\0';
    return field;
}

// The element's symbol, as the columns for it have it. Files from before 1996 have something else
// there, no letters; the atom's name must do then. In it, a symbol of one letter stands in column
// 14: " CA " is an alpha carbon, "CA  " is calcium. But not so long names of hydrogens, "HG11" is
// no mercury; and polymers, the ATOM records, consist of elements with one letter, whatever its
// column.
static const char *symbol_read(const PdbReader *reader, int is_polymer, char *symbol)
{
    static const char LETTERS[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz";
    field_read(reader, 77, 78, symbol);
    if (strspn(symbol, LETTERS) > 0) {
        return symbol;
    }
    char name[FIELD_SIZE];
    field_read(reader, 13, 16, name);
    const int is_long_hydrogen = strlen(name) == 4 && (name[0] == 'H' || name[0] == 'D');
    field_read(reader, 13, 14, name);
    snprintf(symbol, FIELD_SIZE, "%s", name + strcspn(name, LETTERS));
    if (is_polymer || is_long_hydrogen) {
        symbol[1] = '\0';
    }
    return symbol;
}

// Where an atom was found in two places, the file has both, named "A" and "B" mostly. Is this the
// place to draw? In every residue the first one met is.
static int is_location_taken(PdbReader *reader)
{
    char location[FIELD_SIZE], residue[FIELD_SIZE];
    field_read(reader, 17, 17, location);
    field_read(reader, 22, 27, residue);
    if (strcmp(residue, reader->residue) != 0) {
        strcpy(reader->residue, residue);
        reader->location = '\0';
    }
    if (location[0] == '\0') {
        return 1;
    }
    if (reader->location == '\0') {
        reader->location = location[0];
    }
    return reader->location == location[0];
}

static void atom_read(PdbReader *reader, int is_polymer)
{
    Molecule *molecule = &reader->molecule;
    char field[FIELD_SIZE];
    if (!is_location_taken(reader)) {
        return;
    }
    // Without a blank between them, shifted columns would give other numbers, and no fault.
    if (field_read(reader, 28, 30, field)[0] != '\0') {
        char found[LINE_QUOTE_SIZE];
        line_fault(&molecule->lines, "columns 28 to 30: ", line_quote(field, found),
                   "blanks before x");
        return;
    }
    Vec3 point;
    point.x = molecule_read_coordinate(molecule, "x", field_read(reader, 31, 38, field));
    point.y = molecule_read_coordinate(molecule, "y", field_read(reader, 39, 46, field));
    point.z = molecule_read_coordinate(molecule, "z", field_read(reader, 47, 54, field));
    const char *symbol = symbol_read(reader, is_polymer, field);
    molecule_add_atom(molecule, point, element_by_symbol(symbol), symbol);
}

int scene3d_read_pdb(FILE *file, const char *name, Scene3D *scene)
{
    PdbReader reader = {.location = '\0'};
    molecule_begin(&reader.molecule, file, name);
    int at_end = 0;
    while (!at_end && !reader.molecule.lines.failed && line_read(&reader.molecule.lines)) {
        char record[FIELD_SIZE];
        field_read(&reader, 1, 6, record);
        if (strcmp(record, "ATOM") == 0 || strcmp(record, "HETATM") == 0) {
            atom_read(&reader, record[0] == 'A');
        }
        // Of several models of one molecule, which would overlap, the first is read.
        at_end = strcmp(record, "ENDMDL") == 0 || strcmp(record, "END") == 0;
    }
    return molecule_finish(&reader.molecule, scene);
}
