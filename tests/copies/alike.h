// All that is known about a class's answers that are alike, and how it is written down.
#ifndef COPIES_ALIKE_H
#define COPIES_ALIKE_H

#include "pairs.h"

typedef struct Alike {
    HandedIn class;
    Weights weights;
    Pairs pairs;
    const char
        *reports;  // the folder of the page, if it may have students/SLUG/report.html; or NULL
} Alike;

// Read a class's answers of one lab, and compare them (handed_in.h). Returns 0, or -1 after one
// message on stderr. Release with alike_free() in either case.
int alike_read(const char *build, const char *lab, const char *folder, Alike *alike);
void alike_free(Alike *alike);

// Do both authors of a pair have the form, and does it weigh anything?
int is_shared(const Alike *alike, const Pair *pair, int id);

// The page, for the instructor alone. Appears whole or not at all. Returns 0, or -1 after one
// message on stderr.
int copies_page(const Alike *alike, const char *path);

// The same for programs. Returns as above.
int copies_json(const Alike *alike, const char *path);

#endif
