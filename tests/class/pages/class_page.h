// The files that a class is written into; then the parts of class.html, of which each writes a
// section, or nothing where there is nothing to show.
#ifndef CLASS_PAGE_H
#define CLASS_PAGE_H

#include "failures.h"
#include "gradebook.h"
#include "leaderboard.h"
#include "look_alikes.h"
#include "worksheet.h"

// The three files. Each appears whole or not at all; return 0, or -1 after one message.
//   worksheet   the list of participants, whose columns come first in the CSV then, and whose
//               addresses and numbers the JSON has; or NULL
int gradebook_csv(const Gradebook *gradebook, const char *path, const Worksheet *worksheet);
int gradebook_json(const Gradebook *gradebook, const char *path, const Worksheet *worksheet);
int gradebook_page(const Gradebook *gradebook, const char *path, const Worksheet *worksheet);

// The page without names, for the lecture hall: one row for each student, numbered by score, and
// nothing that a student wrote. Returns as above.
int gradebook_page_without_names(const Gradebook *gradebook, const char *path);

// A student's name, linked to the report, with the number of a later attempt.
void class_name_write(FILE *page, const Row *row);

// Whose names look like one person's; what the instructor has to decide.
void class_look_alikes_write(FILE *page, const LookAlikes *look_alikes);

// How many have which score: a drawing, and the same in words.
void class_histogram_write(FILE *page, const Gradebook *gradebook);

// Whose score is not what it was in the older gradebook.
void class_changes_write(FILE *page, const Gradebook *gradebook);

// What the instructor has corrected by hand; a row's alone as rows of a table: change, comment,
// until.
void class_corrections_write(FILE *page, const Gradebook *gradebook);
void class_correction_rows_write(FILE *page, const Gradebook *gradebook, const Row *row);

// Who was late.
void class_late_write(FILE *page, const Gradebook *gradebook);

// All that went wrong, by cause, with who it happened to.
void class_failures_write(FILE *page, const Gradebook *gradebook, const Failures *failures);

// A failure's cause, or else what was said of its first row; "" where that is not for the hall.
const char *class_failure_words(const Failure *failure, int has_names);

// How many answered each task.
void class_tasks_write(FILE *page, const Gradebook *gradebook);

// How many passed each check.
void class_checks_write(FILE *page, const Gradebook *gradebook);

// Whose kernels are the fastest, where the lab has a race.
void class_leaderboard_write(FILE *page, const Gradebook *gradebook,
                             const Leaderboard *leaderboard);

// The first picture of every report.
void class_gallery_write(FILE *page, const Gradebook *gradebook);

#endif
