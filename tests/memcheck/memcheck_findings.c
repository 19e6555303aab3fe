// Findings in words (see memcheck_findings.h).
#include "memcheck_findings.h"

#include "clean_text.h"
#include "crash_line.h"
#include "message.h"
#include "text_file.h"

#include <stdlib.h>
#include <string.h>
#include <unistd.h>

// Print where a finding is in a file of the student's: the line, without its indentation, and the
// task. Returns 0 where the file has no such line.
static int own_place_print(const Memcheck *memcheck, const Finding *finding)
{
    char path[PATH_MAX];
    size_t length = 0;
    variant_file(&memcheck->whole, finding->file, path);
    char *text = text_file_read(path);
    const char *line = text != NULL ? text_line(text, finding->line, &length) : NULL;
    if (line != NULL) {
        char *source = message_new("%.*s", (int)length, line);
        char *clean = line_clean(source + strspn(source, " \t"));
        printf("%s:%d: %s\n        %s\n", finding->file, finding->line, finding->says, clean);
        free(clean);
        free(source);
        const char *task =
            task_of_line(&memcheck->session.manifest, finding->file, text, finding->line);
        if (task != NULL) {
            printf("    in the answer to %s\n", task);
        }
    }
    free(text);
    return line != NULL;
}

// Is it in a given file, at a line that this has?
static int has_given_place(const Finding *finding)
{
    size_t length;
    char *text = access(finding->given, R_OK) == 0 ? text_file_read(finding->given) : NULL;
    const int is_there = text != NULL && text_line(text, finding->given_line, &length) != NULL;
    free(text);
    return is_there;
}

int finding_print(const Memcheck *memcheck, const Finding *finding)
{
    const int is_given = finding->given[0] != '\0' && has_given_place(finding);
    if (finding->file != NULL ? !own_place_print(memcheck, finding) : !is_given) {
        return 0;
    }
    if (finding->file == NULL) {
        printf("%s, line %d, given, with what it got from yours: %s\n", finding->given,
               finding->given_line, finding->says);
    } else if (is_given) {
        printf("    in a given function that is called here: %s, line %d\n", finding->given,
               finding->given_line);
    }
    if (finding->work_item[0] != '\0') {
        printf("    first in work-item %s\n", finding->work_item);
    }
    if (finding->to_do != NULL) {
        printf("    %s\n", finding->to_do);
    }
    return 1;
}
