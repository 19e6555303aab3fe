// Holes: the marked regions of a solution that a student fills in.
//
// A solution holds, for each task,
//
//     // TASK split_box: what to do, in a line or more
//     //> return 0;              what the student finds instead (nothing after //>: an empty line)
//     the solution
//     // END split_box
//
// From that come the skeleton in labs/ (holes_cut), a student's answer to one task put into the
// solution of all others (hole_read and hole_fill), and wrong answers for the tests. Texts are
// handled line by line and never trusted: they may be a submission's.
#ifndef GRADER_HOLES_H
#define GRADER_HOLES_H

enum { HOLE_ID_BYTES = 64 };

// The skeleton of a solution: each hole's solution replaced by its placeholder, markers kept.
// Returns the text, free() it, or NULL after one message on stderr that names `name` and the line
// (a marker without its partner, one inside another, a hole without a placeholder).
char *holes_cut(const char *solution, const char *name);

// The id of the hole number `index` (from 0) in order of the text. Returns 1, or 0 when there are
// fewer.
int hole_id(const char *text, int index, char id[HOLE_ID_BYTES]);

// What stands between the markers of hole `id`, after the comment of the task. Returns the text,
// free() it, or NULL when the markers are not there exactly once each, in order.
char *hole_read(const char *text, const char *id);

// The same of a file. NULL also when it cannot be read, after one message on stderr.
char *hole_load(const char *path, const char *id);

// What is wrong with the markers of hole `id`, with the line, or NULL when they are there exactly
// once each, in order. Returns a message, free() it.
char *hole_fault(const char *text, const char *id);

// Does line `number` of the text, from 1, stand in hole `id`?
int hole_has_line(const char *text, const char *id, int number);

// `solution` with the content of hole `id` replaced by `body`. Returns the text, free() it, or NULL
// when the hole is not in it.
char *hole_fill(const char *solution, const char *id, const char *body);

#endif
