// The files that a class is written into, and the parts of class.html.
#ifndef CLASS_PAGE_H
#define CLASS_PAGE_H

#include "failures.h"
#include "gradebook.h"
#include "leaderboard.h"
#include "look_alikes.h"
#include "worksheet.h"

#include <jansson.h>

// The three files. Each appears whole or not at all; return 0, or -1 after one message.
//   worksheet   the list of participants, whose columns come first in the CSV then, and whose
//               addresses and numbers the JSON has; or NULL
int gradebook_csv(const Gradebook *gradebook, const char *path, const Worksheet *worksheet);
int gradebook_json(const Gradebook *gradebook, const char *path, const Worksheet *worksheet);
int gradebook_page(const Gradebook *gradebook, const char *path, const Worksheet *worksheet);

// The page without names, for the lecture hall: one row for each student, numbered by score, and
// nothing that a student wrote. Returns as above.
int gradebook_page_without_names(const Gradebook *gradebook, const char *path);

// The most frequent mistakes of a class, for the next lecture: how the class did, then a slide for
// each of the five mistakes that most students made, with the check's hint, and a pair of pictures
// of one of them. No name is on them, and no text that a student wrote. Whole or not at all;
// returns 0, or -1 after one message.
int gradebook_slides(const Gradebook *gradebook, const char *path);

// ---- For class.html, which is filled with these values (template.h) --------------------------

// "who": a student's name, linked to the report, with the number of a later attempt.
json_t *class_row(const Row *row);

// How many have which score: a bar for each range.
json_t *class_bars(const Gradebook *gradebook);

// Whose names look like one person's; what the instructor has to decide. NULL: nobody's.
json_t *class_look_alikes(const LookAlikes *look_alikes);

// Whose score is not what it was in the older gradebook; what the instructor has corrected by hand;
// who was late. NULL where that was not given.
json_t *class_compared(const Gradebook *gradebook);
json_t *class_corrections(const Gradebook *gradebook);
json_t *class_late(const Gradebook *gradebook);

// A row's corrections as rows of a table: change, comment, until.
void class_correction_rows_write(FILE *page, const Gradebook *gradebook, const Row *row);

// All that went wrong, by cause, with who it happened to. NULL: nothing did.
json_t *class_failures(const Gradebook *gradebook, const Failures *failures);

// A failure's cause, or else what was said of its first row; "" where that is not for the hall.
const char *class_failure_words(const Failure *failure, int has_names);

// How many answered each task, and how many passed each check.
json_t *class_tasks(const Gradebook *gradebook);
json_t *class_checks(const Gradebook *gradebook);

// Whose kernels are the fastest; NULL where the lab has no race.
json_t *class_leaderboard(const Gradebook *gradebook, const Leaderboard *leaderboard);

// The first picture of every report.
json_t *class_pictures(const Gradebook *gradebook);

#endif
