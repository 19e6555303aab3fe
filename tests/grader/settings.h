// The command line of grade.
#ifndef GRADER_SETTINGS_H
#define GRADER_SETTINGS_H

#include "sandbox.h"

#include <stdint.h>

enum { SETTINGS_PATH_BYTES = 512 };

typedef struct Settings {
    char lab[64];                          // "03-kdtree-2d-render"
    char submission[SETTINGS_PATH_BYTES];  // a folder
    char output[SETTINGS_PATH_BYTES];      // a folder for the reports
    const char *build;                     // where the probes are
    const char *device;                    // "" for the first
    uint64_t seed;
    int time_limit;       // seconds
    SandboxKind sandbox;  // SANDBOX_ANY: the first that works here
    int list_checks;      // only print the lab's checks
} Settings;

// Read the command line. Returns 0, 1 when --help was answered, or -1 after one message on stderr.
int settings_parse(int argc, char **argv, Settings *settings);

#endif
