// Standard input, output and error: what a program is started with, open or not.
//
// Figures are printed for people and for other programs, and neither must take a cut list for a
// whole one. Read next: stats.c.
#ifndef COMMON_STANDARD_STREAMS_H
#define COMMON_STANDARD_STREAMS_H

// Call this before the first file is opened. A stream that the caller closed (`>&-`) would lend its
// number to that file, and what is printed would go there; now it fails.
void standard_streams_begin(void);

// Has all that was printed so far arrived? Returns 0, or -1 after one message on stderr.
int standard_output_check(void);

#endif
