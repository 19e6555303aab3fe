// Folders that cannot hold more than they may, where the grader can mount file systems: as root,
// outside of most containers. Elsewhere the scan alone looks after them, ten times a second.
//
// The mounts are in a mount namespace of the grader's own: nobody else sees them, and they end
// with it however it ends.
#ifndef GRADER_LIMITED_FOLDER_H
#define GRADER_LIMITED_FOLDER_H

// Put an empty file system in memory into the folder's place, a little larger than the limits, so
// that who breaks them is seen to. Does nothing where it cannot.
void limited_folder_mount(const char *path, int n_mb, int n_files);

// Take it away, with all that is in it. Does nothing where there is none.
void limited_folder_unmount(const char *path);

#endif
