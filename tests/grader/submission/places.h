// Where in a submission the lab's files are: the one rule, for folders and for unpacked archives.
//
// Each file is taken from its best place: the top; else labs/NN-name; else the folder with the
// fewest folders above it, as students pack a folder and Moodle, Gradescope and GitHub add one.
// Inside such a folder labs/NN-name again comes just behind the folder itself. Read next: stage.c.
#ifndef GRADER_PLACES_H
#define GRADER_PLACES_H

// How far the search goes. It goes level by level, so that what lies beyond is what is deepest.
enum {
    PLACES_MAX_DEPTH = 8,         // folders above a file
    PLACES_MAX_FOLDERS = 10000,   // looked into
    PLACES_MAX_ENTRIES = 200000,  // files and folders looked at
    PLACES_MAX_EQUAL = 16,        // equally good places kept for one file
};

// Where one file is. Paths are relative to the submission's top, "" is the top itself.
typedef struct Places {
    char *folders[PLACES_MAX_EQUAL];  // equally good, in the order of their bytes; owned
    int n_folders;                    // 0: the file is nowhere
    int are_more;                     // than PLACES_MAX_EQUAL
    int rank;                         // the lower, the better
    char *other;                      // the best of the places that are less good, or NULL; owned
    int other_rank;
} Places;

// How good a folder is for a file of a lab: 0 is the best. -1: nothing is taken from there.
int place_rank(const char *lab, const char *folder);

// Search an open folder for files by name. Whatever has the name counts, also a link or a folder:
// to say so is the caller's. Links are never followed, and what no student writes by hand is passed
// over: hidden folders, __MACOSX, build and the like.
//   top                 the open folder
//   lab                 "03-kdtree-2d-render"
//   files[n_files]      the names
//   places[n_files]     out; release with places_free()
// Returns 0, or -1 with errno set when the top could not be read, or the machine failed. What else
// keeps a folder below it from being read (its rights, that it is gone) is its owner's doing, and
// it is passed over.
int places_find(int top, const char *lab, char *const *files, int n_files, Places *places);
void places_free(Places *places, int n_files);

// Did an operation fail by the machine's doing, and by none of whoever filled the folder?
int place_fault_is_ours(int fault);

// Open a folder below `top`, none on its way through a link. Returns a descriptor, or -1 with errno
// set.
int place_open(int top, const char *folder);

#endif
