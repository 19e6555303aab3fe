// Is there a device to judge on? Asked before anything of a student's runs, so that no submission
// can pass for one that met none.
#ifndef GRADER_DEVICE_H
#define GRADER_DEVICE_H

#include "workdir.h"

// Open the workdir's device in the sandbox, by a program of ours (probes/find_device.c). Returns
// 0, or -1 after one message on stderr, which lists the devices that there are.
int device_find(const Workdir *workdir);

#endif
