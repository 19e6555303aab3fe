// Watching a lab's files: after every save compile, draw and grade, and tell what changed.
//
// A round: judge without a driver, compile, draw, grade. Judging without a driver (tests/native)
// takes half a second, and the verdict of the driver is told only if it is another one. Where that
// cannot be, a round begins with compiling. One command runs at a time. Read next: watch.c, look.h.
#ifndef DESK_WATCH_H
#define DESK_WATCH_H

#include "child.h"
#include "desk.h"
#include "look.h"
#include "saved.h"
#include "watch_page.h"

typedef enum Step {
    STEP_NONE,
    STEP_JUDGING,  // without a driver
    STEP_COMPILING,
    STEP_DRAWING,
    STEP_GRADING,
    STEP_ASKED
} Step;

typedef struct Watch {
    const Desk *desk;
    Look look;               // the open scene, and the folder of the page
    char results[PATH_MAX];  // the grader's
    char seed[24];           // the same for every save: what is gained and lost is the student's
    SavedFiles seen;         // at the last look
    double seen_ms;          // since when they are so
    SavedFiles taken;        // that the last round began with
    SavedFiles built;        // that the program was made of
    Step step;
    int is_judged;      // in this round, without a driver: news.results is that
    int has_no_native;  // it cannot be done here
    Child child;
    News news;
    char keys[8];  // that wait for the round's end
    int n_keys;
    int has_terminal;  // for keys
    double start_ms, round_ms;
} Watch;

// Watch until a key or a signal ends it. Nothing runs any more then, and the terminal is as before.
// Returns 0, or -1 after one message.
int watch_run(const Desk *desk);

// ---- A round (watch_round.c) --------------------------------------------------------------------

// Begin one. `why` is its title; what is saved now is in watch->taken.
void round_begin(Watch *watch, const char *why);

// Only grade, with new scenes, and tell everything.
void round_grade_anew(Watch *watch);

// Follow the first wrong pixel of the open scene, or say that none is known.
void round_follow_pixel(Watch *watch);

// End a drawing that takes too long, and go on to the next step when one has ended. Call this every
// now and then.
void round_go_on(Watch *watch);

// ---- What is told of it, on the terminal and on the page (watch_tell.c) -------------------------

// The keys that the watch obeys when nothing runs.
void keys_print(const Watch *watch);

// Tell the page. `state` is one line, and becomes the news'.
void watch_publish(Watch *watch, char *state);

// Put a text in the place of one that is owned.
void text_replace(char **text, char *by);

// Print words of a program, each line under the round's.
void said_print(const char *said);

// Keep of what was said the compiler's words: make's own lines are no news.
void keep_compilers_words(char *said);

// How long the round has taken until now.
double seconds_of_round(const Watch *watch);

// What judges in the end: PoCL, or the device that was asked for.
const char *driver_name(const Watch *watch);

// Take a verdict for the news, and tell what it changes and where the faults are.
//   since   what it is held against, in words
void verdict_take(Watch *watch, json_t *now, const char *since);

#endif
