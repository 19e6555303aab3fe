// JSON documents for the reports (see json_text.h).
//
// Flow: judging -> result -> REPORTS. Read next: report_json.c.
#include "json_text.h"

#include "clean_text.h"
#include "output_file.h"

#include <stdlib.h>

json_t *json_line(const char *line)
{
    char *clean = line_clean(line);
    json_t *string = json_string(clean);
    free(clean);
    return string;
}

json_t *json_message(const char *message)
{
    char *clean = message_clean(message);
    json_t *string = json_string(clean);
    free(clean);
    return string;
}

int json_save(const char *path, json_t *json, size_t layout)
{
    if (json == NULL) {
        fprintf(stderr, "%s: cannot write: a figure is not finite, or no memory\n", path);
        return -1;
    }
    OutputFile output;
    if (output_file_open(&output, path) != 0) {
        json_decref(json);
        return -1;
    }
    const int written = json_dumpf(json, output.file, layout | JSON_REAL_PRECISION(6)) == 0;
    fputc('\n', output.file);
    json_decref(json);
    if (!written) {
        output_file_discard(&output);
        fprintf(stderr, "%s: cannot write\n", path);
        return -1;
    }
    return output_file_commit(&output);
}
