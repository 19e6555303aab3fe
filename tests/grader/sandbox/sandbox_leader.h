// The process between a run's supervisor and its command: it becomes bwrap, or the command itself.
#ifndef GRADER_SANDBOX_LEADER_H
#define GRADER_SANDBOX_LEADER_H

#include "sandbox_walls.h"

// In a child of the supervisor: leave what is the supervisor's, and go behind the walls. Where that
// fails it ends with 127, after one message on `output`.
//   output   where the command's standard output and errors go
//   status   where it says that the command starts and how it ends
_Noreturn void leader_become(const Walls *walls, int output, int status);

#endif
