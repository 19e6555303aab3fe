// JSON documents for the reports: text of unknown origin as strings, and whole files.
#ifndef GRADER_JSON_TEXT_H
#define GRADER_JSON_TEXT_H

#include <jansson.h>

// A string of one line, and one of several, cleaned (clean_text.h). NULL when memory runs out; as
// jansson makes NULL of all that NULL becomes a part of, only json_save() need ask.
json_t *json_line(const char *line);
json_t *json_message(const char *message);

// Append an entry to a list, which takes it over, and becomes NULL where memory runs out.
void json_add(json_t **list, json_t *entry);

// Write `json` to a file that appears whole or not at all, and release it.
//   json    NULL is refused: it stands for a figure that is not finite, or for no memory
//   layout  JSON_INDENT(n) or JSON_COMPACT
// Returns 0, or -1 after one message on stderr.
int json_save(const char *path, json_t *json, size_t layout);

#endif
