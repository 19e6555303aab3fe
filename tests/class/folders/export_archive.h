// An export that is an archive, as a course system gives it out.
#ifndef CLASS_EXPORT_ARCHIVE_H
#define CLASS_EXPORT_ARCHIVE_H

#include <limits.h>

// Unpack an archive in the sandbox. What is unpacked may belong to the sandbox's user, so it is to
// be copied before anything else runs there.
//   build     with tools/unpack
//   folder    an empty one that others may pass; removed by the caller
//   unpacked  out: FOLDER/unpack-0/out, with what the archive holds; where that is nothing but a
//             folder of the archive's own name, or one with several folders or archives, that one:
//             what is above it, such as Stud.IP's list, stays there
// Returns 0, or -1 after one message on stderr.
int export_archive_unpack(const char *build, const char *archive, const char *folder,
                          char unpacked[PATH_MAX]);

#endif
