// The Test Anything Protocol, version 13 (see report_systems.h): a test a stage and a check.
//
// Messages are comments, which every reader of TAP shows or drops, and none takes for a test:
// each of their lines begins with "# ". What did not run is a skipped test, as in JUnit XML.
// Flow: judging -> result -> REPORTS. Read next: report_junit.c.
#include "clean_text.h"
#include "output_file.h"
#include "report_systems.h"
#include "report_words.h"

#include <stdlib.h>
#include <string.h>

// A description: one line in which "#" does not begin a directive.
static void description_write(FILE *file, const char *text)
{
    char *clean = line_clean(text);
    for (const char *at = clean; *at != '\0'; at++) {
        if (*at == '#' || *at == '\\') {
            fputc('\\', file);
        }
        fputc(*at, file);
    }
    free(clean);
}

static void comment_write(FILE *file, const char *text)
{
    char *clean = message_clean(text);
    for (const char *line = clean; *line != '\0';) {
        const size_t length = strcspn(line, "\n");
        fprintf(file, "# %.*s\n", (int)length, line);
        line += length + (line[length] == '\n');
    }
    free(clean);
}

static void test_write(FILE *file, int number, const char *group, const char *title,
                       CheckStatus status)
{
    fprintf(file, "%sok %d - ", status == CHECK_FAILED ? "not " : "", number);
    description_write(file, group);
    fputs(": ", file);
    description_write(file, title);
    fputs(status == CHECK_NOT_RUN ? " # SKIP not run\n" : "\n", file);
}

int report_tap(const char *path, const Manifest *manifest, const Result *result)
{
    OutputFile output;
    if (output_file_open(&output, path) != 0) {
        return -1;
    }
    FILE *file = output.file;
    int number = 0;
    fprintf(file, "TAP version 13\n1..%d\n", result->n_stages + result->n_checks);
    for (int i = 0; i < result->n_stages; i++) {
        const StageResult *stage = &result->stages[i];
        test_write(file, ++number, result->lab, stage->title, stage->status);
        comment_write(file, stage->message);
    }
    for (int i = 0; i < result->n_checks; i++) {
        const CheckResult *check = &result->checks[i];
        char *words = check_words(manifest, result, check);
        test_write(file, ++number, check->task, check->title, check->status);
        comment_write(file, words);
        free(words);
    }
    char *points = points_words(result->score, result->max_score);
    comment_write(file, points);
    free(points);
    return output_file_commit(&output);
}

int report_tap_fault(const char *path, const char *lab)
{
    OutputFile output;
    if (output_file_open(&output, path) != 0) {
        return -1;
    }
    fputs("TAP version 13\nBail out! ", output.file);
    description_write(output.file, lab);
    fputs(": " FORMATS_FAULT_TEXT "\n", output.file);
    return output_file_commit(&output);
}
