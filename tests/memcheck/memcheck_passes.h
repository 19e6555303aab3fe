// Running a submission's probe under Oclgrind, and what was found.
//
// Read next: oclgrind_log.h.
#ifndef GRADER_MEMCHECK_PASSES_H
#define GRADER_MEMCHECK_PASSES_H

#include "advice.h"
#include "oclgrind_log.h"
#include "session.h"

// One submission under Oclgrind.
typedef struct Memcheck {
    Session session;
    Variant whole;
    char folder[PATH_MAX];  // of the submission's files
    int has_trouble;        // it did not run to its end
    Finding findings[MAX_FINDINGS];
    int n_findings;
    int n_told;  // of these
} Memcheck;

// Run the submission, whose files are in the folder and whose host files are compiled, until
// something is found in one of them: that is told on stdout at once, and the run is over. So is told
// how a run ended that did not come to its end. Returns 0, or -1 after one message when the
// machinery failed.
int memcheck_passes(Memcheck *memcheck);

#endif
