// Findings in words (see memcheck_findings.h).
#include "memcheck_findings.h"

#include "clean_text.h"
#include "holes.h"
#include "path.h"
#include "text_file.h"

#include <stdlib.h>
#include <string.h>

// Print a line of one of the student's files, without its indentation.
static void source_print(const Memcheck *memcheck, const char *name, int line)
{
    char path[PATH_MAX], text[512];
    path_make(path, "%s/%s", memcheck->folder, name);
    FILE *file = fopen(path, "r");
    for (int at = 0; file != NULL && at < line && fgets(text, sizeof text, file) != NULL;) {
        const size_t length = strlen(text);
        at += length > 0 && text[length - 1] == '\n';
        if (at == line) {
            char *clean = line_clean(text + strspn(text, " \t"));
            printf("        %s\n", clean);
            free(clean);
        }
    }
    if (file != NULL) {
        fclose(file);
    }
}

// The task whose answer a line stands in, or NULL.
static const char *task_of_line(const Memcheck *memcheck, const char *name, int line)
{
    const Manifest *manifest = &memcheck->session.manifest;
    const char *found = NULL;
    char path[PATH_MAX];
    path_make(path, "%s/%s", memcheck->folder, name);
    char *text = text_file_read(path);
    for (int i = 0; text != NULL && found == NULL && i < manifest->n_tasks; i++) {
        const Task *task = &manifest->tasks[i];
        found =
            strcmp(task->file, name) == 0 && hole_has_line(text, task->id, line) ? task->id : NULL;
    }
    free(text);
    return found;
}

void finding_print(const Memcheck *memcheck, const Finding *finding)
{
    if (finding->file != NULL) {
        printf("%s:%d: %s\n", finding->file, finding->line, finding->says);
        source_print(memcheck, finding->file, finding->line);
        const char *task = task_of_line(memcheck, finding->file, finding->line);
        if (task != NULL) {
            printf("    in the answer to %s\n", task);
        }
        if (finding->given[0] != '\0') {
            printf("    in a given function that is called here: %s, line %d\n", finding->given,
                   finding->given_line);
        }
    } else {
        printf("%s, line %d, given, with what it got from yours: %s\n", finding->given,
               finding->given_line, finding->says);
    }
    if (finding->work_item[0] != '\0') {
        printf("    first in work-item %s\n", finding->work_item);
    }
    if (finding->to_do != NULL) {
        printf("    %s\n", finding->to_do);
    }
}
