// Molecules as 3D scenes: the readers of two formats, and what they share: atom by atom while a
// file is read, then the view and the lights. Labs do not need it.
//
// Read next: elements.h, molecule_xyz.c.
#ifndef COMMON_MOLECULE_H
#define COMMON_MOLECULE_H

#include "elements.h"
#include "line_reader.h"
#include "scene3d_builder.h"

// Read a molecule: PDB (the ATOM and HETATM records of its first model, every atom once: of each
// residue's alternate locations the first) or XYZ (its first frame). Atoms become spheres with
// their van-der-Waals radii and CPK colours (elements.h), in Angstrom; elements that are not known
// are drawn pink, counted and named in one warning. Coordinates lie within a million Angstrom. The
// view is placed so that all atoms are seen in a picture at least as wide as high, 512x512 when the
// user gives no size. A PDB file that ends within an atom's name or coordinates, which have fixed
// columns, was cut and is refused; of the other formats only the number of numbers tells. Where the
// last line has no line end and nothing else is wrong, one warning says that it may have been cut
// (all formats). Returns 0, or -1 after one message on stderr.
int scene3d_read_pdb(FILE *file, const char *name, Scene3D *scene);
int scene3d_read_xyz(FILE *file, const char *name, Scene3D *scene);

// How many of the unknown elements a warning names.
#define MOLECULE_MAX_NAMES 5

typedef struct Molecule {
    LineReader lines;
    Scene3DBuilder builder;
    int n_unknown;                                    // atoms whose element is unknown
    char names[MOLECULE_MAX_NAMES][LINE_QUOTE_SIZE];  // the first names of theirs, in quotes
    int n_names;
    int has_more_names;
    int64_t n_elsewhere;    // atoms that are left out: these are drawn at another location
    int64_t n_rest;         // what is left out behind the first model or frame
    const char *rest, *of;  // what these are: "atom", "of other models"
    int64_t cut_line;       // in which the file ends within the name of a record; 0: in none
} Molecule;

// Get ready to read a file (see line_reader_begin()).
void molecule_begin(Molecule *molecule, FILE *file, const char *name);

// Read a coordinate.
//   axis   "x", "y" or "z", for messages
// Returns Angstrom; 0 after a complaint about the current line.
float molecule_read_coordinate(Molecule *molecule, const char *axis, const char *text);

// Add an atom at a point, Angstrom.
//   element   NULL when it is unknown: the atom is then drawn as ELEMENT_UNKNOWN and counted
//   name      what the file calls the element
void molecule_add_atom(Molecule *molecule, Vec3 point, const Element *element, const char *name);

// Leave out the rest of the file, and count its lines for the warning.
//   rest, of     what is left out: "atom", "of other models"
//   is_counted   is this line one?
void molecule_leave_out(Molecule *molecule, const char *rest, const char *of,
                        int (*is_counted)(const char *line));

// Place the view so that all atoms are seen in a picture that is at least as wide as high, light
// the scene, and hand it over; a molecule without atoms is a fault. Prints one warning when
// elements were unknown, atoms left out, or the file ends too soon. Returns 0, or -1 after one
// message on stderr; everything is then released.
int molecule_finish(Molecule *molecule, Scene3D *scene);

#endif
