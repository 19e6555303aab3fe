// Finding an answer that another task's function gives (see borrowing.h).
//
// Flow: staged -> compiled -> run -> judged -> ALONE. Called by grade.c before an answer is tried
// beside our solution of the other tasks. Read next: source_words.h.
#include "borrowing.h"

#include "holes.h"
#include "source_words.h"
#include "text_file.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

// Does a text name it, but for a member of a structure? With `call`, only where it is called.
static int is_named(const char *text, const char *name, int call)
{
    SourceReader reader = source_reader(text);
    SourceWord last = {0};
    int is_found = 0;
    for (SourceWord word = source_next(&reader); word.kind != SOURCE_END;) {
        const SourceWord next = source_next(&reader);
        const int is_member =
            source_is(&last, SOURCE_SIGN, ".") || source_is(&last, SOURCE_SIGN, "->");
        is_found |= source_is(&word, SOURCE_NAME, name) && !is_member &&
                    (!call || source_is(&next, SOURCE_SIGN, "("));
        last = word;
        word = next;
    }
    return is_found;
}

// One of the lab's solution files, or NULL after one message on stderr.
static char *solution_read(const Manifest *manifest, const char *file)
{
    char path[512];
    snprintf(path, sizeof path, "solutions/%s/%s", manifest->lab, file);
    return text_file_read(path);
}

const Task *borrowed_task(const Manifest *manifest, const Task *task, const char *answer)
{
    const Task *borrowed = NULL;
    char *own_file = solution_read(manifest, task->file);
    char *own_answer = own_file ? hole_read(own_file, task->id) : NULL;
    for (int t = 0; t < manifest->n_tasks && own_answer != NULL && borrowed == NULL; t++) {
        const Task *other = &manifest->tasks[t];
        char *file = strcmp(other->id, task->id) != 0 ? solution_read(manifest, other->file) : NULL;
        // Tasks that are a part of a function have an id that names nothing.
        if (file != NULL && is_named(file, other->id, 1) && is_named(answer, other->id, 0) &&
            !is_named(own_answer, other->id, 0)) {
            borrowed = other;
        }
        free(file);
    }
    free(own_answer);
    free(own_file);
    return borrowed;
}
