// Late work: who handed in after the deadline, and the points that this costs, `DUE=` and `LATE=`.
//
// When something was handed in is what the instructor says, or what the course system wrote. What a
// student can write decides nothing (course_system.h): such a row is the instructor's to decide, as
// one of which nobody knows the time. Tasks keep their points: what lateness costs is taken from
// the sum, after the instructor's corrections. Read next: lateness.c, late_times.c, moment.h.
#ifndef CLASS_LATENESS_H
#define CLASS_LATENESS_H

#include "worksheet.h"

#include <time.h>

// What is known of a row.
typedef struct LateRow {
    int has_time;
    time_t handed_in;
    int is_marked;    // no time, but somebody's word that it was late
    int is_unmarked;  // no time either: the system marks late work, and has not marked this
    int is_said;      // the instructor said it
    char *unknown;    // why nobody can say whether it was in time, behind why nobody can say whose
                      // it is; NULL: it is known
    time_t due;       // the deadline, or the end of the last day of the student's extension
    long seconds;     // after that; 0: in time, or not known
    int off;          // the points taken off
} LateRow;

// Room for a duration.
enum { LATENESS_BYTES = 40 };

typedef struct Lateness {
    time_t due;
    int takes_points;  // else lateness is only shown
    int amount;        // points, or percent of the lab's points
    int is_percent;
    long unit;  // for each so many seconds begun; 0: once
    long limit,
        limit_unit;  // later than so many units of so many seconds earns nothing; 0: no limit
    LateRow *rows;   // [n_rows] of the gradebook; NULL before lateness_apply()
    int n_rows;
} Lateness;

// Read what make was given.
//   due    "2026-11-25 23:59", with a zone behind it if it is not this machine's:
//          "2026-11-25 23:59 Europe/Berlin". All of that minute is in time
//   late   "10%/day,2days": ten percent of the lab's points for each day begun, nothing after two
//          days; "5/hour", "20%"; or NULL: no points are taken off
// Returns 0, or -1 after one message on stderr. Sets the zone of moment.h.
int lateness_read(const char *due, const char *late, Lateness *lateness);
void lateness_free(Lateness *lateness);

// Find out who was late, take off the points, and make the lateness the gradebook's.
//   worksheet   the list of participants, or NULL
// Returns 0, or -1 after one message, where a time of the list cannot be read.
int lateness_apply(Lateness *lateness, Gradebook *gradebook, const Worksheet *worksheet);

// For lateness_apply(): fill in what lateness->rows, whose deadlines are known, can know of the
// time. Where only a student can have written it, or nobody has, it stays unknown. Returns as
// above, also where what the instructor wrote is no time.
int late_times_find(Lateness *lateness, const Gradebook *gradebook, const Worksheet *worksheet);

// A row's; NULL where no deadline was given.
const LateRow *lateness_of(const Gradebook *gradebook, const Row *row);

// Was it handed in late? NULL: no deadline was given, so nothing was.
int lateness_is_late(const LateRow *late);

// "handed in 2026-11-26 10:05 CET, 10 h 5 min late: 10 points off", not escaped; nothing where the
// row is not late.
void lateness_write(FILE *file, const Gradebook *gradebook, const Row *row);

// How late: "10 h 5 min", "2 days 3 h".
void lateness_duration(long seconds, char text[LATENESS_BYTES]);

// For the terminal: the deadline with its zone, how many were late, and whose word that is.
void lateness_tell(const Gradebook *gradebook);

// What follows "handed in": when, and how late.
void lateness_when_write(FILE *file, const LateRow *late);

// A system that writes no times has marked what is late by its own deadline. Its name, and of how
// many that is all that is known; NULL: of none.
const char *lateness_marks_find(const Gradebook *gradebook, int *n);

#endif
