// What the watch tells of a round, on the terminal and on its page.
//
// Read next: watch_page.h.
#ifndef DESK_WATCH_TELL_H
#define DESK_WATCH_TELL_H

#include "watch_round.h"

// The keys that the watch obeys when nothing runs.
void keys_print(const Watch *watch);

// Tell the page. `state` is one line, and becomes the news'.
void watch_publish(Watch *watch, char *state);

// Put a text in the place of one that is owned.
void text_replace(char **text, char *by);

// Print words of a program, each line under the round's.
void said_print(const char *said);

// Keep of what was said the compiler's words: make's own lines are no news.
void keep_compilers_words(char *said);

// How long the round has taken until now.
double seconds_of_round(const Watch *watch);

// What judges in the end: PoCL, or the device that was asked for.
const char *driver_name(const Watch *watch);

// Take a verdict for the news, and tell what it changes and where the faults are.
//   since   what it is held against, in words
void verdict_take(Watch *watch, json_t *now, const char *since);

#endif
