// Paths of files and folders, made from their parts.
#ifndef COMMON_PATH_H
#define COMMON_PATH_H

#include <limits.h>

// Make a path like printf makes texts. One that is too long for the system is not cut off, as that
// would be another file's: it ends in a name longer than any file's, and whoever opens it gets
// ENAMETOOLONG.
__attribute__((format(printf, 2, 3))) void path_make(char path[PATH_MAX], const char *format, ...);

#endif
