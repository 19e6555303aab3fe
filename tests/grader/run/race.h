// What a race is worth, for a leaderboard: how many times as fast as a reference kernel a
// submission's draws one scene. Both draw in turn in one process in the sandbox (variant_race() in
// variant.h); here are only the times that it wrote down, which a submission can forge. So the
// figure is a number within limits, or none, and gives and costs no points.
//
// Read next: ../../probes/race_answers.h, what is written down.
#ifndef GRADER_RACE_H
#define GRADER_RACE_H

#include "sections.h"

// The limits of a figure: what a right kernel is far within. It has one decimal, as runs differ by
// more than what would stand behind.
#define RACE_LEAST 0.1
#define RACE_MOST 1000.0

// Is this a figure of a race?
int race_is_figure(double figure);

// The reference's median time over the submission's; 0 where the answers have no such figure: a
// time is missing or no time, the pictures differ, or the figure is outside the limits.
double race_judge(const Sections *answers);

#endif
