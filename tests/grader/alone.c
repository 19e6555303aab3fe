// Trying the answer to one task alone (see alone.h).
//
// Called by grading_alone.c for each task with a failed check. Read next:
// tests/stubs/README.md.
#include "alone.h"

#include "holes.h"
#include "nonce.h"
#include "path.h"
#include "skeleton.h"
#include "text_file.h"

#include <stdlib.h>
#include <string.h>

// The number for NONCE in the stubs while a task is tried. Where a check of it may say what was
// found (is_same_alone), none depends on that number, and it is not the seed's: however an answer
// calls or reads a stub, the report does not tell the number.
static uint32_t nonce_of(const Session *session, const Task *task)
{
    for (int i = 0; i < session->judge.n_checks; i++) {
        const Check *check = &session->judge.checks[i];
        if (check->is_same_alone && strcmp(check->task, task->id) == 0) {
            return 0;
        }
    }
    return stub_nonce(session->settings->seed);
}

// What stands in the hole of a task that is not tried: its stub, or what is handed out. NULL
// after one message.
static char *other_body(const Manifest *manifest, const Task *task, uint32_t nonce)
{
    char *stub = stub_read(manifest, task, nonce);
    return stub != NULL ? stub : placeholder_read(manifest, task);
}

// Fill a hole. Takes `text` over, also where there is no such hole. Returns the text, or NULL.
static char *settle(char *text, const Task *task, const char *body)
{
    char *filled = text != NULL && body != NULL ? hole_fill(text, task->id, body) : NULL;
    free(text);
    return filled;
}

// Take the other tasks' answers out of one of the lab's files, and put this one's in: last, as
// nobody knows what is in it. Takes `text` over. Returns the text, or NULL when a hole is missing.
static char *holes_settle(const Session *session, const char *file, const Task *task,
                          const char *answer, char *text)
{
    const Manifest *manifest = &session->manifest;
    for (int t = 0; t < manifest->n_tasks; t++) {
        const Task *other = &manifest->tasks[t];
        if (other != task && strcmp(other->file, file) == 0) {
            char *body = other_body(manifest, other, nonce_of(session, task));
            text = settle(text, other, body);
            free(body);
        }
    }
    return strcmp(task->file, file) == 0 ? settle(text, task, answer) : text;
}

// Are the student's own host files left out where a task is tried alone? They could do a kernel's
// work for it.
static int is_kept_out(const Task *task, const char *file)
{
    return manifest_is_host_file(file) && !manifest_is_host_file(task->file);
}

// One of the lab's files with this answer: the student's own, or where that has no such holes, may
// not be there or `own` is NULL, the one that is handed out. NULL after one message.
static char *file_text(const Session *session, const char *file, const Task *task,
                       const char *answer, const char *own, int *is_changed)
{
    char path[PATH_MAX];
    char *text = skeleton_read(&session->manifest, file);
    text = text != NULL ? holes_settle(session, file, task, answer, text) : NULL;
    if (own == NULL || text == NULL || is_kept_out(task, file)) {
        return text;
    }
    path_make(path, "%s/%s", own, file);
    char *own_text = text_file_read(path);
    own_text = own_text != NULL ? holes_settle(session, file, task, answer, own_text) : NULL;
    if (own_text == NULL || strcmp(own_text, text) == 0) {
        free(own_text);
        return text;
    }
    *is_changed = 1;
    free(text);
    return own_text;
}

int alone_fill(Session *session, const char *name, const Task *task, const char *answer,
               const char *own, Variant *variant)
{
    const Manifest *manifest = &session->manifest;
    char job[PATH_MAX];
    int result = variant_open(&session->workdir, name, variant);
    variant->alone = task->id;
    variant_job_path(variant, job);
    for (int i = 0; result == 0 && i < manifest->n_files; i++) {
        const char *file = manifest->files[i];
        result = variant_put(variant, file,
                             file_text(session, file, task, answer, own, &variant->is_changed));
    }
    return result == 0 ? session_write_job(&session->judge, task->id, job) : -1;
}
