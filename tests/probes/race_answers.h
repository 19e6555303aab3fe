// What the race of a lab with a leaderboard writes down, besides the device: how long the reference
// kernel and the submission's took for one scene, in turn, and what each drew last. What that is
// worth is worked out by the grader (tests/grader/run/race.h): whatever runs beside a student's
// code may lie.
//     "times"       RaceTimes
//     "picture.K"   of racer K: [RACE_SIDE][RACE_SIDE], RGBA, a byte each
#ifndef PROBES_RACE_ANSWERS_H
#define PROBES_RACE_ANSWERS_H

typedef enum Racer { RACE_REFERENCE, RACE_OWN, N_RACERS } Racer;

// The picture's side, pixels; and how often each draws. A round takes less than 0.1 s of a CPU.
enum { RACE_SIDE = 512, RACE_ROUNDS = 7 };
#define RACE_PICTURE_BYTES ((size_t)RACE_SIDE * RACE_SIDE * 4)

// Milliseconds a frame.
typedef struct RaceTimes {
    double ms[N_RACERS][RACE_ROUNDS];
} RaceTimes;

#endif
