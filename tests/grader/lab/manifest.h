// A lab's manifest, solutions/NN-name/lab.json: which files a student hands in, which tasks (the
// marked holes) there are, and how many points each check of a task earns. Points are in no other
// place. It belongs to the instructor's tree, never to a submission.
//
//     { "title": "Naive 2D rendering",
//       "files": ["overlaps_N_Nearer.cl", "implicit2DRenderer.cl"],
//       "tasks": [ { "id": "overlaps_N_Nearer", "file": "overlaps_N_Nearer.cl",
//                    "title": "Does a circle cover the pixel?",
//                    "points": { "overlaps-inside": 30, "overlaps-boundary": 70 },
//                    "hint": "...", "hints": { "overlaps-boundary": "..." },
//                    "more_hints": [ "where to look", "what to draw", "the formula" ] } ],
//       "leaderboard": "times as fast as lab 00's kernel",
//       "hours": 2, "look": "--scene random:n=500", "figure": "01-naive-2d.png" }
//
// An instructor's own points make another such file of it (class/points/points_tool.c), with one
// more field, and 0 points for a check that is turned off:
//
//       "changed": { "says": "1 check is off (points.csv)", "total": 90,
//                    "hidden": ["overlaps-inside"], "time_limit": 30, "seed": "7" }
#ifndef GRADER_MANIFEST_H
#define GRADER_MANIFEST_H

#include <stdint.h>

enum {
    MANIFEST_MAX_FILES = 8,
    MANIFEST_MAX_TASKS = 6,
    MANIFEST_MAX_CHECKS = 8,  // of a task
    MANIFEST_MORE_HINTS = 3,  // of a task that has any
};

typedef struct TaskCheck {
    const char *id;    // as the judge has it
    int points;        // 0: turned off
    int is_hidden;     // what it finds is not for students
    const char *hint;  // in place of the task's, or NULL
} TaskCheck;

typedef struct Task {
    const char *id;     // as in the markers "// TASK id: ..." and "// END id"
    const char *file;   // one of the manifest's files
    const char *title;  // one line for people
    const char *hint;   // shown when one of its checks fails and no message has said why
    const char *more_hints[MANIFEST_MORE_HINTS];  // after the first one, for who asks; or all NULL
    TaskCheck checks[MANIFEST_MAX_CHECKS];
    int n_checks;
} Task;

typedef struct Manifest {
    struct json_t *json;  // the file as it was read, which holds all texts below; owned
    char lab[64];         // "01-naive-2d"
    const char *title;
    const char *files[MANIFEST_MAX_FILES];  // plain names without a folder
    int n_files;
    Task tasks[MANIFEST_MAX_TASKS];
    int n_tasks;
    // What a figure counts that no points depend on: "times as fast as ..."; NULL in a lab without
    // a race (run/race.h).
    const char *leaderboard;
    int hours;            // planned for it; 0 where nothing is said
    const char *look;     // options with which its program draws in a moment; NULL: none
    const char *changed;  // how an instructor has changed points and hints, or NULL
    int time_limit;       // the instructor's: seconds as for grade --time-limit; 0: none
    int has_seed;         // the instructor's, for the hidden scenes
    uint64_t seed;
    const char *figure;  // in slides-notes/figures: what a right answer draws with them; NULL: none
} Manifest;

// Read labs_folder/lab/lab.json. Returns 0, or -1 after one message on stderr (missing, no JSON, a
// field missing or of the wrong type, unknown fields, a file name with a slash or a leading dot, a
// task whose file is not listed, an id given twice, points that do not add up to 100 or to what an
// instructor's own file says, a hint for a check without points, a leaderboard where host files are
// handed in, which a race could not be built with ahead). Whether the judge has the same checks:
// judge_start().
int manifest_load(const char *labs_folder, const char *lab, Manifest *manifest);
// Likewise from any file; NULL: the lab's own.
int manifest_load_file(const char *path, const char *lab, Manifest *manifest);
void manifest_free(Manifest *manifest);

// Is the solution of the lab here? A handout has those of earlier labs only.
int manifest_has_solution(const char *lab);

// The labs' folder that counts: "solutions", or "labs" where the solution is not here.
const char *manifest_folder(const char *lab);

// The hint for a check of the task: its own, or the task's.
const char *manifest_hint(const Task *task, const char *check);

// The check with this id, of any task, or NULL.
const TaskCheck *manifest_check(const Manifest *manifest, const char *id);

// The task with this id, or NULL.
const Task *manifest_task(const Manifest *manifest, const char *id);

// The number of the file with this name, or -1: students do not hand it in.
int manifest_file(const Manifest *manifest, const char *name);

// Is this file C for the host, and not a kernel?
int manifest_is_host_file(const char *name);

// Do students hand in host files of this lab?
int manifest_has_host_files(const Manifest *manifest);

// Do they hand in kernels? Only then a device is needed.
int manifest_has_kernels(const Manifest *manifest);

#endif
