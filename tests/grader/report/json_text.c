// JSON documents for the reports (see json_text.h).
//
// Read next: report_json.c.
#include "json_text.h"

#include "clean_text.h"
#include "complain.h"
#include "output_file.h"

#include <stdlib.h>

static json_t *json_clean(char *clean)
{
    json_t *string = json_string(clean);
    free(clean);
    return string;
}

json_t *json_line(const char *line)
{
    return json_clean(line_clean(line));
}

json_t *json_message(const char *message)
{
    return json_clean(message_clean(message));
}

void json_add(json_t **list, json_t *entry)
{
    if (json_array_append_new(*list, entry) != 0) {
        json_decref(*list);
        *list = NULL;
    }
}

int json_save(const char *path, json_t *json, size_t layout)
{
    if (json == NULL) {
        complain("%s: cannot write: a figure is not finite, or no memory", path);
        return -1;
    }
    OutputFile output;
    if (output_file_open(&output, path) != 0) {
        json_decref(json);
        return -1;
    }
    const int dumped = json_dumpf(json, output.file, layout | JSON_REAL_PRECISION(6)) == 0;
    // Of a file that cannot be written output_file_commit() says why.
    const int written = dumped || ferror(output.file);
    fputc('\n', output.file);
    json_decref(json);
    if (!written) {
        output_file_discard(&output);
        complain("%s: cannot write", path);
        return -1;
    }
    return output_file_commit(&output);
}
