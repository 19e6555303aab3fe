// The solution's answers, and what time it took for them, kept from one grading to the next: of one
// lab, one seed, one device and one grader they are always the same, and a class asks for them
// again and again.
//
// Whoever names the folder sees to it that it is of one lab, one device and one grader, and that no
// submission reaches it. Read next: session.c.
#ifndef GRADER_KEPT_ANSWERS_H
#define GRADER_KEPT_ANSWERS_H

#include "allowance.h"
#include "sections.h"

// Load the answers to a seed's job, and note the time they took. Returns 0, or -1 where there are
// none.
int kept_answers_load(const char *folder, uint64_t seed, Sections *answers, Allowance *allowance);

// Keep answers that were found right. Returns 0, or -1 after one message on stderr.
int kept_answers_save(const char *folder, uint64_t seed, const Sections *answers,
                      const Allowance *allowance);

#endif
