// The command line of grade, and of mutants, mutate and memcheck, which use a part of it.
#ifndef GRADER_SETTINGS_H
#define GRADER_SETTINGS_H

#include "sandbox.h"

#include <limits.h>
#include <stdint.h>

typedef struct Settings {
    char lab[64];               // "03-kdtree-2d-render"
    char submission[PATH_MAX];  // a folder or an archive
    char output[PATH_MAX];      // a folder for the reports
    const char *student;        // whose it is, for the reports; NULL: they name the submission
    const char *task;           // the one that stdout tells of; NULL: see tells_first
    int has_no_report;          // only results.json is written
    int tells_first;            // stdout tells of the first task that failed, else of all
    const char *manifest;       // a lab.json with an instructor's own points; NULL: the lab's
    const char *build;          // where the probes are
    const char *device;         // "" for the first
    const char *kept_answers;   // see kept_answers.h; NULL: the solution is run
    uint64_t seed;
    int time_limit;       // seconds of processor time; 0: see allowance.h
    int deadline;         // seconds of wall time from the start, 0 for none: see allowance.h
    SandboxKind sandbox;  // SANDBOX_ANY: the first that works here
    int list_checks;      // only print the lab's checks
} Settings;

// Read the command line. Returns 0, 1 when --help was answered, or -1 after one message on stderr.
int settings_parse(int argc, char **argv, Settings *settings);

// Where code that must not be trusted runs: as a command line says, NULL where it does not, or else
// the environment. Returns 0, or -1 after one message on stderr.
int settings_find_sandbox(const char *given, SandboxKind *kind);

#endif
