// One round of the watch: judge without a driver, compile, draw, grade; what is told of each.
//
// Judging without a driver (tests/native) takes half a second, and the verdict of the driver is
// told only if it is another one. Where that cannot be, a round begins with compiling. One command
// runs at a time. Read next: look.h, watch_tell.h.
#ifndef DESK_WATCH_ROUND_H
#define DESK_WATCH_ROUND_H

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

// Begin one. `why` is its title; what is saved now is in watch->taken.
void round_begin(Watch *watch, const char *why);

// Only grade, with new scenes, and tell everything.
void round_grade_anew(Watch *watch);

// Follow the first wrong pixel of the open scene, or say that none is known.
void round_follow_pixel(Watch *watch);

// End a drawing that takes too long, and go on to the next step when one has ended. Call this every
// now and then.
void round_go_on(Watch *watch);

#endif
