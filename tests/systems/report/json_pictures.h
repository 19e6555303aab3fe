// A result's pictures for documents in JSON.
#ifndef GRADER_JSON_PICTURES_H
#define GRADER_JSON_PICTURES_H

#include "json_text.h"
#include "result.h"

// A list of {"label": ..., "url": "data:..."}: of each scene where the student's picture is not the
// reference, the student's own, the reference, and their difference. What would make the list,
// written compactly, longer than `max_bytes` is left out. NULL after one message on stderr.
json_t *json_pictures(const Result *result, size_t max_bytes);

#endif
