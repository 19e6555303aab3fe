// What stands around one sandboxed command, of any kind: made by its supervisor, entered by the
// process that becomes the command, taken down when all is over. Internal to the sandbox.
#ifndef GRADER_SANDBOX_WALLS_H
#define GRADER_SANDBOX_WALLS_H

#include "sandbox.h"

#include <limits.h>
#include <sys/types.h>

// Descriptors of the process that enters the walls, besides the standard ones. Bubblewrap tells on
// the first of the command's start and its exit code, as JSON; entering other walls writes the same
// "child-pid" there. From the second, the filter of system calls is read. The others are for
// bubblewrap: from one it takes the program of its process 1, which tells on the other, another way
// to the first, of the command's start.
enum {
    WALLS_STATUS_DESCRIPTOR = 9,
    WALLS_FILTER_DESCRIPTOR = 10,
    WALLS_INIT_DESCRIPTOR = 11,
    WALLS_STARTED_DESCRIPTOR = 12,
};

// The unprivileged user and group that bubblewrap is run as by root where a run can have none of
// its own: nobody and nogroup.
#define WALLS_NOBODY 65534

typedef struct Walls {
    SandboxCommand command;  // its mounts with absolute paths
    char **bwrap;            // bubblewrap's argument list
    char **environment;      // the command's own
    uid_t user;              // whom the writable mounts belong to and what is inside runs as
    mode_t modes[SANDBOX_MAX_MOUNTS];  // of the first n_given mounts, before they were handed over
    int n_given;
    int filter;           // a descriptor to read the filter of system calls from
    char view[PATH_MAX];  // without bubblewrap: the run's own folder; "" while there is none
} Walls;

// Before the supervisor is started: what can be wrong with the command itself. Returns 0, or -1
// after one message on stderr.
int walls_prepare(const SandboxCommand *command, Walls *walls);

// In the supervisor: choose the user, hand the writable mounts over, make the view. Returns 0, or
// -1 with errno set and *step saying what could not be done.
int walls_make(Walls *walls, const char **step);

// In the process that becomes the command. Returns only when that fails, with errno set.
void walls_enter(const Walls *walls, const char **step);

// In the supervisor, any number of times: kill whatever runs as the run's own user, if it has one.
void walls_end_user(const Walls *walls);

// In the supervisor, when all processes have ended: take the mounts and the view back, and remove
// what the run's own user left where everybody may write.
void walls_take_down(Walls *walls);

void walls_free(Walls *walls);

#endif
