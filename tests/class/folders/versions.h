// Several versions of a lab's file in one submission: "gradient.cl" and "gradient (2).cl".
//
// ILIAS keeps every upload, and other systems number files of one name, which may be those of two
// people. No name says which one is the last. So each version is graded, as an entry of its own,
// and the instructor decides (owners.h). Read next: roster.c.
#ifndef CLASS_VERSIONS_H
#define CLASS_VERSIONS_H

#include "manifest.h"
#include "places.h"

// More versions of a file than this are not graded.
enum { VERSIONS_MAX = 16, VERSION_DIGEST_BYTES = 32 };

// Files of other names than another's have another content.
typedef struct FileVersions {
    Place places[VERSIONS_MAX];  // the plain name first, then by number; below the folder
    unsigned char digests[VERSIONS_MAX][VERSION_DIGEST_BYTES];
    int n;
} FileVersions;

typedef struct Versions {
    FileVersions of[MANIFEST_MAX_FILES];  // of each of the lab's files
    int n;                                // how many versions the file with the most has
    int has_more;                         // than VERSIONS_MAX
} Versions;

// Find the versions of the lab's files in a folder: with names that a system may have given, where
// the grader would look for the file. Returns 0, or -1 after one message. Release with
// versions_free().
int versions_find(const char *folder, const Manifest *manifest, Versions *versions);
void versions_free(Versions *versions);

// The place by which version i is known: of the first file that has several.
const Place *version_place(const Versions *versions, int i);

// Collect version i in a new folder: of each lab's file that version or the last, under its plain
// name, and what else is in the folder's top. Returns 0, or -1 after one message.
int version_collect(const char *folder, const Manifest *manifest, const Versions *versions, int i,
                    const char *to);

#endif
