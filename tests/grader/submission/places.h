// Where in a submission the lab's files are: the one rule, for folders and for unpacked archives.
//
// Each file is taken from its best place: the top; else labs/NN-name; else the folder with the
// fewest folders above it, as students pack a folder and Moodle, Gradescope and GitHub add one.
// Inside such a folder labs/NN-name again comes just behind the folder itself. A file with the
// exact name comes before any that a system renamed. Read next: file_names.h, stage_file.c.
#ifndef GRADER_PLACES_H
#define GRADER_PLACES_H

// How far the search goes. It goes level by level, so that what lies beyond is what is deepest.
enum {
    PLACES_MAX_DEPTH = 8,         // folders above a file
    PLACES_MAX_FOLDERS = 10000,   // looked into
    PLACES_MAX_ENTRIES = 200000,  // files and folders looked at
    PLACES_MAX_EQUAL = 16,        // equally good places kept for one file
};

// How good a place is, the lower the better: first the name counts, then the folder. From RANK_TOLD
// on nothing is taken from there, but where there is nothing better, it is told.
enum {
    RANK_CHANGED = 100,  // a system changed the name (file_names.h)
    RANK_TOLD = 200,
    RANK_NEAR = RANK_TOLD,   // the student did
    RANK_PASSED_OVER = 300,  // in a folder that holds what no student writes by hand
};

// One place. Both owned; "" is the top.
typedef struct Place {
    char *folder;  // relative to the submission's top
    char *name;    // the file's, there
} Place;

// Where one file is.
typedef struct Places {
    Place equal[PLACES_MAX_EQUAL + 1];  // equally good, in the order of place_compare()
    int n_equal;                        // 0: the file is nowhere
    int are_more;                       // than PLACES_MAX_EQUAL
    int rank;
    Place other;  // the best of the places that are less good, or NULLs
    int other_rank;
} Places;

// Which of a lab's files may a file of this name in this folder be, and how good is the place?
// Returns its number with *rank; or -1.
int place_of(const char *lab, const char *const *files, int n_files, const Place *place, int *rank);

// A copy, to be released with place_free(). Its name is NULL when memory runs out.
Place place_copy(const Place *place);
void place_free(Place *place);

// Negative where the first place comes before the second: by folder, in one folder the later upload
// (file_names.h), then by name.
int place_compare(const Place *a, const Place *b);

// Search an open folder for files by name. Whatever has the exact name counts, also a link or a
// folder: to say so is the caller's. Links are never followed. Nothing is taken from folders with
// what no student writes by hand: hidden ones, __MACOSX, build and the like. Where a file is
// nowhere else, it is looked for there, so that the caller can say so.
//   top                 the open folder
//   lab                 "03-kdtree-2d-render"
//   files[n_files]      the names
//   places[n_files]     out; release with places_free()
// Returns 0, or -1 with errno set when the top could not be read, or the machine failed. What else
// keeps a folder below it from being read (its rights, that it is gone) is its owner's doing, and
// it is passed over.
int places_find(int top, const char *lab, const char *const *files, int n_files, Places *places);
void places_free(Places *places, int n_files);

// Did an operation fail by the machine's doing, and by none of whoever filled the folder?
int place_fault_is_ours(int fault);

// Open a folder below `top`, none on its way through a link. Returns a descriptor, or -1 with errno
// set.
int place_open(int top, const char *folder);

// The same, and make the folders that are not there.
int place_make(int top, const char *folder);

#endif
