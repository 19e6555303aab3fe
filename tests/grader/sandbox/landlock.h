// Landlock: a process gives up the right to open files, but for those it names first.
#ifndef GRADER_LANDLOCK_H
#define GRADER_LANDLOCK_H

typedef enum LandlockAccess {
    LANDLOCK_LIST,    // list folders, open no file
    LANDLOCK_READ,    // and read and execute
    LANDLOCK_WRITE,   // and make, change, move and remove files
    LANDLOCK_DEVICE,  // read, write and control a device that is there
} LandlockAccess;

// A new set of rules, closed on exec, that allows nothing yet: no file, and where the kernel knows
// of them no TCP port, no signal and no abstract socket of those outside. -1 with errno set when it
// cannot be made; ENOSYS where Landlock is older than LANDLOCK_OLDEST.
enum { LANDLOCK_OLDEST = 2 };  // Linux 5.19: files may be moved from folder to folder, as PoCL does
int landlock_open(void);

// Allow access to a file or to all below a folder; what does not exist is left out. Returns 0, or
// -1 with errno set.
int landlock_allow(int rules, const char *path, LandlockAccess access);

// Put this thread and all that it will start under the rules. Needs PR_SET_NO_NEW_PRIVS. Returns 0,
// or -1 with errno set.
int landlock_enter(int rules);

#endif
