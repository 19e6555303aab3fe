// Findings in words (see memcheck_findings.h).
#include "memcheck_findings.h"

#include "clean_text.h"
#include "holes.h"
#include "path.h"
#include "text_file.h"

#include <stdlib.h>
#include <string.h>

// Is it one of the files a student hands in? Then *name is its name without a folder.
static int is_own_file(const Memcheck *memcheck, const char *path, const char **name)
{
    const char *slash = strrchr(path, '/');
    *name = slash ? slash + 1 : path;
    for (int i = 0; i < memcheck->session.manifest.n_files; i++) {
        if (strcmp(memcheck->session.manifest.files[i], *name) == 0) {
            return 1;
        }
    }
    return 0;
}

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

const Finding *finding_first_own(const Memcheck *memcheck)
{
    const char *name;
    for (int i = 0; i < memcheck->n_findings; i++) {
        if (is_own_file(memcheck, memcheck->findings[i].file, &name)) {
            return &memcheck->findings[i];
        }
    }
    return NULL;
}

void finding_print(const Memcheck *memcheck, const Finding *finding)
{
    const char *name, *other;
    if (is_own_file(memcheck, finding->file, &name)) {
        printf("%s:%d: %s\n", name, finding->line, finding->says);
        source_print(memcheck, name, finding->line);
        const char *task = task_of_line(memcheck, name, finding->line);
        if (task != NULL) {
            printf("    in the answer to %s\n", task);
        }
    } else {
        char *clean = line_clean(name);
        printf("%s, line %d, given, with what it got from yours: %s\n", clean, finding->line,
               finding->says);
        free(clean);
    }
    if (finding->other_file[0] != '\0' && is_own_file(memcheck, finding->other_file, &other)) {
        printf("    the other one is at %s:%d\n", other, finding->other_line);
    }
    if (finding->work_item[0] != '\0') {
        printf("    first in work-item %s\n", finding->work_item);
    }
}
