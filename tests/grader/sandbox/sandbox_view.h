// Without bubblewrap there are no mounts: a folder of links stands for them.
#ifndef GRADER_SANDBOX_VIEW_H
#define GRADER_SANDBOX_VIEW_H

#include "sandbox.h"

#include <limits.h>
#include <sys/types.h>

// Make a folder of the run's own under $TMPDIR or /tmp, with a private "tmp" that belongs to `user`
// and a link for every mount: what is seen as /work behind bubblewrap is seen as `view`/work. Of a
// folder with another mount inside, the entries are linked one by one. Returns 0, or -1 with errno
// set. `view` receives the folder as soon as there is one; folder_remove() it.
int view_make(const SandboxCommand *command, uid_t user, char view[PATH_MAX]);

#endif
