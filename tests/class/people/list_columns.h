// Which system wrote a list of participants, and which of its columns takes the grades.
//
// A list of Moodle has one such column. Canvas, Blackboard and Brightspace write one for each
// assignment: it is found by the lab's number in its title, or named by the instructor (COLUMN=).
// Read next: worksheet.h, upload_csv.h.
#ifndef CLASS_LIST_COLUMNS_H
#define CLASS_LIST_COLUMNS_H

#include "worksheet.h"

// How the system takes grades, in words: "in Canvas choose Grades, Import". NULL: nobody knows.
const char *list_upload_words(ListSystem system);

// Find the system by the head, the column of grades, what is its maximum, and which columns the
// system wants to read again; they are written into the worksheet.
//   wanted       the column's title, with or without what the system adds to it; NULL: by number
//   lab_number   of the lab that was graded; -1: nothing was
// Returns 0, or -1 after one message on stderr. No column of grades at all is no fault.
int list_columns_find(Worksheet *worksheet, const char *wanted, int lab_number);

#endif
