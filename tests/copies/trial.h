// Reading an author's answers for trial, in a process that may be ended: what one person wrote must
// not keep the instructor from the others.
#ifndef COPIES_TRIAL_H
#define COPIES_TRIAL_H

// What reading all answers of one author may use. Answers that people write take milliseconds.
enum { TRIAL_SECONDS = 10, TRIAL_MB = 64 };

// Do something that only computes, in a process of its own with these limits. Returns 1 if it came
// to its end; then it can be done here, too. Returns 0 if it did not, or if no process could be
// started.
int trial_ends(void (*what)(void *context), void *context);

#endif
