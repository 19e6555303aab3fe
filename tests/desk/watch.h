// Watching a lab's files: after every save compile, draw and grade, and tell what changed.
#ifndef DESK_WATCH_H
#define DESK_WATCH_H

#include "desk.h"

// Watch until a key or a signal ends it. Nothing runs any more then, and the terminal is as before.
// Returns 0, or -1 after one message.
int watch_run(const Desk *desk);

#endif
