// Molecules in files of the Protein Data Bank (see molecule.h).
//
// A line is a record; its first six columns say which. Everything stands in fixed columns, as on
// punched cards, often without a blank between. Atoms are read, everything else is passed over.
// Read next: molecule.c.
//
// Source: wwPDB, "Protein Data Bank Contents Guide: Atomic Coordinate Entry Format", version 3.3,
// 2012, sections ATOM, HETATM and MODEL.
#include "molecule.h"

#include "number.h"

#include <ctype.h>
#include <search.h>
#include <stdlib.h>
#include <string.h>

// The widest field that is read, and its NUL.
#define FIELD_SIZE 9

#define LAST_COLUMN 54  // where an atom's z ends

static const char LETTERS[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz";

// An atom that was taken from a residue.
typedef struct Taken {
    char name[5];
    char location;  // which of its alternate locations; '\0' where it has but one
} Taken;

typedef struct PdbReader {
    Molecule molecule;
    char residue[FIELD_SIZE];  // the one whose atoms are being read
    char location;             // which of its alternate locations is taken; '\0' until one is met
    void *taken;               // its atoms so far by name, a tree of search.h
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

// Some programs write a name of four signs a column too far to the right, as " HG11": its last sign
// then stands where an alternate location has its name. Such a location is a letter mostly, and the
// atom is not always there: its occupancy is less than 1.
static int is_name_shifted(const PdbReader *reader)
{
    char name[FIELD_SIZE], occupancy[FIELD_SIZE];
    const int length = (int)strlen(field_read(reader, 14, 17, name));
    float share = 0;
    number_read_float(field_read(reader, 55, 60, occupancy), &share);
    const int is_whole = field_read(reader, 13, 13, occupancy)[0] == '\0' && length == 4 &&
                         strchr(name, ' ') == NULL;
    return is_whole && (share >= 1 || (share <= 0 && strchr(LETTERS, name[3]) == NULL));
}

// An atom's name, and the column in which it begins.
static int name_read(const PdbReader *reader, char *name)
{
    const int shift = is_name_shifted(reader);
    field_read(reader, 13 + shift, 16 + shift, name);
    char first[FIELD_SIZE];
    return !shift && field_read(reader, 13, 13, first)[0] == '\0' ? 14 : 13;
}

// Is an atom all of its residue? The residue is then named after it: "CA", "ZN2".
static int is_ion(const char *name, const char *residue)
{
    const size_t length = strlen(name);
    return length >= 2 && strncasecmp(name, residue, length) == 0 &&
           strpbrk(residue + length, LETTERS) == NULL;
}

// An alpha carbon is CA; not calcium, wherever in its columns the name stands. So are the others on
// the way along a chain, the nitrogens of a haem, and the phosphorus of ATP.
static int is_in_chain(const char *letters)
{
    static const char *const NAMES[] = {"CA", "CD", "CE", "NB", "ND", "NE", "PA", "PB"};
    for (size_t i = 0; i < sizeof NAMES / sizeof NAMES[0]; i++) {
        if (strncasecmp(letters, NAMES[i], 2) == 0) {
            return 1;
        }
    }
    return 0;
}

// "HG11", "HO5'" and "HE1" are no mercury, holmium and helium.
static int is_hydrogen(const char *name, const char *letters)
{
    return (letters[0] == 'H' || letters[0] == 'D') &&
           (strlen(name) == 4 ||
            (strspn(letters, LETTERS) == 2 && isdigit((unsigned char)letters[2])));
}

// The element's symbol, as the columns for it have it. Files from before 1996, and of some
// programs, have something else there, no letters; the atom's name must do then. In it, a symbol of
// one letter stands in column 14, one of two in 13: " CB " is carbon, "FE  " iron. But not so the
// names above; and polymers, the ATOM records, consist of elements with one letter, whatever its
// column. A small second letter tells by itself.
static const char *symbol_read(const PdbReader *reader, int is_polymer, char *symbol)
{
    field_read(reader, 77, 78, symbol);
    if (strspn(symbol, LETTERS) > 0) {
        return symbol;
    }
    char name[FIELD_SIZE], residue[FIELD_SIZE];
    const int column = name_read(reader, name);
    const char *letters = name + strcspn(name, LETTERS);
    const int is_first = column == 13 && letters == name;
    const int has_two =
        is_ion(letters, field_read(reader, 18, 20, residue)) ||
        (!is_in_chain(letters) && ((letters[0] != '\0' && islower((unsigned char)letters[1])) ||
                                   (is_first && !is_polymer && !is_hydrogen(name, letters))));
    snprintf(symbol, FIELD_SIZE, "%.2s", letters);
    if (!has_two || (element_by_symbol(symbol) == NULL &&
                     element_by_symbol((const char[]){symbol[0], 0}) != NULL)) {
        symbol[1] = '\0';
    }
    return symbol;
}

// ---- Alternate locations ------------------------------------------------------------------------

static int compare_names(const void *left, const void *right)
{
    return strcmp(((const Taken *)left)->name, ((const Taken *)right)->name);
}

// Note that an atom is taken, unless one of its name was. Returns the location of the first one.
static char location_note(PdbReader *reader, Taken atom)
{
    const Taken *const *known = tfind(&atom, &reader->taken, compare_names);
    if (known != NULL) {
        return (*known)->location;
    }
    Taken *copy = malloc(sizeof *copy);
    if (copy == NULL) {
        line_fault(&reader->molecule.lines, "", "no memory", "a smaller scene");
        return atom.location;
    }
    *copy = atom;
    if (tsearch(copy, &reader->taken, compare_names) == NULL) {
        free(copy);
        line_fault(&reader->molecule.lines, "", "no memory", "a smaller scene");
    }
    return atom.location;
}

static void residue_begin(PdbReader *reader, const char *residue)
{
    strcpy(reader->residue, residue);
    reader->location = '\0';
    tdestroy(reader->taken, free);
    reader->taken = NULL;
}

// Where an atom was found in two places, the file has both, named "A" and "B" mostly; some files
// leave the first one's name blank. Is this the place to draw? Of the names the first one met in a
// residue is; of an atom both with a name and without, the first one met. Two atoms of one name and
// no other difference are two: small molecules call every carbon "C".
static int is_location_taken(PdbReader *reader)
{
    char location[FIELD_SIZE], residue[FIELD_SIZE];
    const int shift = is_name_shifted(reader);
    Taken atom = {.name = ""};
    field_read(reader, 17, shift ? 16 : 17, location);
    field_read(reader, 22, 27, residue);
    if (strcmp(residue, reader->residue) != 0) {
        residue_begin(reader, residue);
    }
    atom.location = location[0];
    // With its blanks: " CA " is an alpha carbon, "CA  " may be calcium.
    if (strlen(reader->molecule.lines.text) > 13) {
        snprintf(atom.name, sizeof atom.name, "%s", reader->molecule.lines.text + 12 + shift);
    }
    if (location[0] != '\0' && reader->location != '\0' && reader->location != location[0]) {
        return 0;
    }
    if (location_note(reader, atom) != location[0]) {
        return 0;
    }
    if (location[0] != '\0') {
        reader->location = location[0];
    }
    return 1;
}

// ---- Records ------------------------------------------------------------------------------------

static void atom_read(PdbReader *reader, int is_polymer)
{
    Molecule *molecule = &reader->molecule;
    char field[FIELD_SIZE];
    const int length = (int)strlen(molecule->lines.text);
    if (molecule->lines.unended_line != 0 && length < LAST_COLUMN) {
        char found[LINE_QUOTE_SIZE];
        snprintf(found, sizeof found, "the end of the file in column %d", length);
        line_fault(&molecule->lines, "", found,
                   "x, y and z up to column " NUMBER_TEXT(LAST_COLUMN));
        return;
    }
    if (!is_location_taken(reader)) {
        molecule->n_elsewhere++;
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
    point.z = molecule_read_coordinate(molecule, "z", field_read(reader, 47, LAST_COLUMN, field));
    const char *symbol = symbol_read(reader, is_polymer, field);
    molecule_add_atom(molecule, point, element_by_symbol(symbol), symbol);
}

static int is_atom(const char *line)
{
    return strncmp(line, "ATOM  ", 6) == 0 || strncmp(line, "HETATM", 6) == 0;
}

// Is a line the beginning of a record's name, and not all of it?
static int is_begun(const char *line, const char *name)
{
    const size_t length = strlen(line);
    return length < strlen(name) && strncmp(line, name, length) == 0;
}

// A file may end in the name of a record. Of an atom's it is a fault; of another one, as END, no
// atom need be missing, and it is noted for a warning.
static void cut_name_check(Molecule *molecule, const char *record)
{
    LineReader *lines = &molecule->lines;
    if (lines->unended_line == 0) {
        return;
    }
    if (is_begun(lines->text, "ATOM") || is_begun(lines->text, "HETATM")) {
        line_fault(lines, "", "the end of the file in the name of a record", "a whole record");
    } else if (strcmp(record, "END") != 0 &&
               (is_begun(lines->text, "END") || is_begun(lines->text, "ENDMDL"))) {
        molecule->cut_line = lines->line;
        lines->unended_line = 0;  // another message says so
    }
}

int scene3d_read_pdb(FILE *file, const char *name, Scene3D *scene)
{
    PdbReader reader = {.location = '\0'};
    molecule_begin(&reader.molecule, file, name);
    int at_end = 0;
    while (!at_end && !reader.molecule.lines.failed && line_read(&reader.molecule.lines)) {
        LineReader *lines = &reader.molecule.lines;
        char record[FIELD_SIZE];
        field_read(&reader, 1, 6, record);
        cut_name_check(&reader.molecule, record);
        if (strcmp(record, "ATOM") == 0 || strcmp(record, "HETATM") == 0) {
            atom_read(&reader, record[0] == 'A');
        }
        // Of several models of one molecule, which would overlap, the first is read.
        at_end = strcmp(record, "ENDMDL") == 0 || strcmp(record, "END") == 0;
        if (at_end) {
            lines->unended_line = 0;  // whatever follows is not missed
            molecule_leave_out(&reader.molecule, "atom", "of other models", is_atom);
        }
    }
    tdestroy(reader.taken, free);
    return molecule_finish(&reader.molecule, scene);
}
