// Limits of the shell that the grader was started from: ulimit.
#ifndef GRADER_HOST_LIMITS_H
#define GRADER_HOST_LIMITS_H

// See to it that programs may write files and use memory as a grading needs: as far as the host
// lets us, the limits are raised. What goes on with too little of it is hard to tell from a fault
// of a submission's. Returns 0, or -1 after one message on stderr.
int host_limits_raise(void);

#endif
