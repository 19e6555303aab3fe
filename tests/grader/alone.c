// Trying the answer to one task alone (see alone.h).
//
// Flow: staged -> compiled -> run -> judged -> ALONE. Called by grade.c for each task with a failed
// check. Read next: tests/stand_ins/README.md.
#include "alone.h"

#include "holes.h"
#include "jobs.h"
#include "skeleton.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

enum { PATH_BYTES = 512 };

// Replace *text by the same with a hole filled. Returns 0, or -1 after one message.
static int fill(char **text, const Task *task, const char *body)
{
    char *filled = hole_fill(*text, task->id, body);
    if (filled == NULL) {
        fprintf(stderr, "grade: %s: no hole for task %s\n", task->file, task->id);
    }
    free(*text);
    *text = filled;
    return filled != NULL ? 0 : -1;
}

// One of the lab's files: as it is handed out, with the answer and the stand-ins of the other
// tasks. NULL after one message.
static char *file_text(const Manifest *manifest, const char *file, const Task *task,
                       const char *answer)
{
    char *text = skeleton_read(manifest, file);
    for (int t = 0; text != NULL && t < manifest->n_tasks; t++) {
        const Task *other = &manifest->tasks[t];
        char *stand_in = other != task ? stand_in_read(manifest, other) : NULL;
        const char *body = other == task ? answer : stand_in;
        if (body != NULL && strcmp(other->file, file) == 0) {
            fill(&text, other, body);
        }
        free(stand_in);
    }
    return text;
}

int alone_fill(Session *session, const char *name, const Task *task, const char *answer,
               Variant *variant)
{
    const Manifest *manifest = &session->manifest;
    char folder[PATH_BYTES], job[PATH_BYTES];
    int result = variant_open(&session->workshop, name, variant, folder, sizeof folder);
    variant->alone = task->id;
    for (int i = 0; result == 0 && i < manifest->n_files; i++) {
        char *text = file_text(manifest, manifest->files[i], task, answer);
        result = text == NULL ? -1 : session_write(folder, manifest->files[i], text);
        free(text);
    }
    if (result != 0) {
        return -1;
    }
    variant_job_path(&session->workshop, variant, job, sizeof job);
    FILE *file = fopen(job, "wb");
    int failed = file == NULL ||
                 section_write(file, PROBE_ALONE, task->id, strlen(task->id)) != 0 ||
                 judge_job(&session->judge, task->id, file) != 0;
    failed |= file != NULL && fclose(file) != 0;
    if (failed || chmod(job, 0644) != 0) {
        fprintf(stderr, "grade: %s: cannot be written: %s\n", job, strerror(errno));
        return -1;
    }
    return 0;
}

int alone_passes(Session *session, int i, const Variant *variant)
{
    return judge_passes_alone(&session->judge, (Answers){variant->number, &variant->answers}, i);
}
