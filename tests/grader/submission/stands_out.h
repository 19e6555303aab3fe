// What stands out in a submission: a note for the instructor, never a reason for points.
//
// A look at the texts that were handed in, for what no answer of any lab needs: starting processes,
// opening files, code before main, paths outside of the lab. It names what an attack tried where
// the sandbox only saw a file that is not there. It can be evaded, by a macro that glues a name
// together for one: the defence is the sandbox, and this is no part of it.
#ifndef GRADER_STANDS_OUT_H
#define GRADER_STANDS_OUT_H

#include "manifest.h"

#include <stdio.h>

// Look at a lab's files after staging.
//   staged       the folder with the manifest's files as they were handed in
//   submission   the folder that they came from: what else is in it gets named
// Returns notes, a line each, "render.c:12: fork(): no answer needs it", or NULL when there are
// none; owned by the caller. They quote the submission: not clean text yet.
char *stands_out(const Manifest *manifest, const char *staged, const char *submission);

// The part of it that looks at one text, and counts the notes it writes to `notes`.
//   name   the file's, for the notes
int stands_out_in_text(const char *name, const char *text, FILE *notes);

// The part that names, in one line, the entries of folder `submission` that neither were asked for
// nor come with the lab, and a manifest that is not the lab's own. None of them is opened but the
// manifest. Returns how many notes were written: 0 or 1. Of a submission that is no folder there
// are none.
int stands_out_in_folder(const Manifest *manifest, const char *submission, FILE *notes);

// For the student: characters in a text, outside of its comments, strings and characters, that look
// like others, or like nothing. A compiler's error at them is a riddle, as the line looks right.
// Write a line for each to `notes`, with the line of `name` and the code point, but for no more
// than a few. Returns how many there are.
int stands_out_unseen(const char *name, const char *text, FILE *notes);

#endif
