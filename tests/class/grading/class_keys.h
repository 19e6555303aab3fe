// Which hidden scenes each entry gets, and how it is seen later whether it has to be graded again.
//
// What is new or changed in a run makes up a round. A round's seeds are its own: reports that were
// handed back show much of a job, and no content that was handed in later meets that job. So a
// round is named by what is in it, a hash over the new entries' names and contents. No counter can
// be lost: new content makes a new name, and with it new seeds, even if FOLDER/rounds is gone.
//
// Called once a run by gradebook_tool.c. Read next: class_secret.h.
#ifndef CLASS_CLASS_KEYS_H
#define CLASS_CLASS_KEYS_H

#include <stdint.h>
#include <stdio.h>

// Give each entry its round, its seed and its key.
//   folder    in/out: FOLDER/rounds keeps a line "SLUG CONTENT ROUND" of each entry that was ever
//             there. FOLDER/keys becomes a line "SLUG KEY SEED" for each that is there now.
//   number    of class_secret_open()
//   grader    a hash of all that decides on a score besides the content and the seed
//   contents  a line "SLUG CONTENT" for each entry, CONTENT being a hash of all that is in it
// FOLDER/rounds is complete before FOLDER/keys appears: nothing is graded by a round that a run
// killed in between would forget. Returns 0, or -1 after one message on stderr.
int class_keys_make(const char *folder, const uint64_t *number, const char *grader, FILE *contents);

#endif
