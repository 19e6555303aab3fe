// A moment as a course system or a person writes it: "Wednesday, 25 November 2026, 11:05 PM".
//
// Read next: lateness.h, which compares it with a deadline.
#ifndef CLASS_MOMENT_H
#define CLASS_MOMENT_H

#include <time.h>

enum { MOMENT_BYTES = 48 };

// All times that say no zone are local ones of this zone, from here on.
//   zone   "Europe/Berlin", "UTC" or "+01:00"; NULL: this machine's
// Returns 0, or -1 where there is no such zone.
int moment_zone_set(const char *zone);

// Read a moment. Returns 0, or -1 where it is none.
//   2026-11-25 23:59, 2026-11-25T23:59:30+01:00, 2026-11-25 23:59:30.5 -0800   ISO 8601, Git,
//                                                                              Gradescope
//   2026-11-25-23-59-30, 2026-11-25-23-59, 20261125235930                      names of files
//   25.11.2026 23:59                                                           German
//   Wednesday, 25 November 2026, 11:59 PM; Mittwoch, 25. November 2026, 23:59  Moodle
// With slashes nobody can tell the day from the month, so that is none.
// Where clocks go back, a time of the hour that they show twice is the first of the two moments,
// unless the text has a zone. Where they go forward, a time that no clock shows is the earlier of
// the two that it may be.
int moment_read(const char *text, time_t *moment);

// So many units of so many seconds later. Whole days are those of the calendar, so the clock shows
// the same time; all smaller units are real time.
time_t moment_later(time_t moment, long n, long unit);

// "2026-11-25 23:59 CET".
void moment_write(time_t moment, char text[MOMENT_BYTES]);

// "2026-11-25 23:59:00 +0100", which moment_read() reads again.
void moment_stamp(time_t moment, char text[MOMENT_BYTES]);

#endif
