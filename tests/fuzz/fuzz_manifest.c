// Any bytes as a lab's manifest: what is taken keeps every promise of manifest.h, and what is
// refused gets one message.
#include "fuzz.h"

#include "manifest.h"

static int is_listed(const Manifest *manifest, const char *file)
{
    for (int i = 0; i < manifest->n_files; i++) {
        if (strcmp(manifest->files[i], file) == 0) {
            return 1;
        }
    }
    return 0;
}

static void check_manifest(const Manifest *manifest)
{
    int points = 0;
    MUST_HOLD(manifest->title[0] != '\0');
    MUST_HOLD(manifest->n_files >= 1 && manifest->n_files <= MANIFEST_MAX_FILES);
    MUST_HOLD(manifest->n_tasks >= 1 && manifest->n_tasks <= MANIFEST_MAX_TASKS);
    for (int i = 0; i < manifest->n_files; i++) {
        const char *file = manifest->files[i];
        MUST_HOLD(file[0] != '\0' && file[0] != '.' && strchr(file, '/') == NULL);
    }
    for (int i = 0; i < manifest->n_tasks; i++) {
        const Task *task = &manifest->tasks[i];
        MUST_HOLD(manifest_task(manifest, task->id) == task);
        MUST_HOLD(is_listed(manifest, task->file));
        MUST_HOLD(task->title[0] != '\0' && task->hint[0] != '\0');
        MUST_HOLD(task->n_checks >= 1 && task->n_checks <= MANIFEST_MAX_CHECKS);
        for (int j = 0; j < task->n_checks; j++) {
            const TaskCheck *check = &task->checks[j];
            MUST_HOLD(manifest_hint(task, check->id) == (check->hint ? check->hint : task->hint));
            MUST_HOLD(check->points > 0 || (manifest->changed != NULL && check->points == 0));
            points += check->points;
        }
    }
    MUST_HOLD(points == 100 || manifest->changed != NULL);
    MUST_HOLD(manifest->leaderboard == NULL ||
              (manifest->leaderboard[0] != '\0' && !manifest_has_host_files(manifest)));
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t n_bytes)
{
    InputFile input;
    input_file_make(bytes, n_bytes, &input);
    Manifest manifest;
    Messages messages;
    messages_begin(&messages);
    const int result = manifest_load(input.folder, "lab", &manifest);
    messages_end(&messages);
    MUST_HOLD(result == (messages.length == 0 ? 0 : -1));
    free(messages.text);
    if (result == 0) {
        check_manifest(&manifest);
    }
    manifest_free(&manifest);
    input_file_remove(&input);
    return 0;
}
