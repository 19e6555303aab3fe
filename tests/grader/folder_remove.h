// Removing a folder that somebody else filled.
#ifndef GRADER_FOLDER_REMOVE_H
#define GRADER_FOLDER_REMOVE_H

// Remove a folder with all that is in it: folders deeper than any path is long, and folders that
// were locked. Links in it are removed, never followed. Returns 0 (also where there is none), or -1
// with errno set when something stays.
int folder_remove(const char *path);

#endif
