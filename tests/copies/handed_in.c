// Staging each entry of a class, and reading the holes (see handed_in.h).
#include "handed_in.h"

#include "clean_text.h"
#include "complain.h"
#include "folder.h"
#include "form_list.h"
#include "holes.h"
#include "path.h"
#include "scope.h"
#include "settings.h"
#include "skeleton.h"
#include "submission.h"
#include "text_file.h"
#include "trial.h"
#include "untouched.h"
#include "workdir_files.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static int machine_fault(const char *path)
{
    complain("copies: %s: %s", path, strerror(errno));
    return -1;
}

// ---- One entry -------------------------------------------------------------------------------

static char *hole_of(const Manifest *manifest, const Task *task, const char *staged)
{
    char path[PATH_MAX];
    path_make(path, "%s/%s", staged, task->file);
    char *text = access(path, F_OK) == 0 ? hole_load(path, task->id) : NULL;
    if (text != NULL && answer_is_untouched(manifest, task, text)) {
        free(text);
        text = NULL;
    }
    return text;
}

// The page lists it, too (hard.h).
static void given_up_tell(const Entrant *entrant)
{
    char *label = line_clean(entrant->label);
    complain("copies: \"%s\" takes more than %d s of processor time or %d MB to read, and is not "
             "compared",
             label, TRIAL_SECONDS, TRIAL_MB);
    free(label);
}

typedef struct Reading {
    const HandedIn *class;
    Author *author;
} Reading;

static void forms_of(void *context)
{
    const Reading *reading = context;
    for (int i = 0; i < reading->class->manifest.n_tasks; i++) {
        Answer *answer = &reading->author->answers[i];
        if (answer->text != NULL) {
            answer->forms = forms_read(answer->text, &reading->class->scopes[i]);
        }
    }
}

// Returns how many tasks have an answer.
static int answers_read(const HandedIn *class, const char *staged, Author *author)
{
    const Manifest *manifest = &class->manifest;
    Reading reading = {class, author};
    int n = 0;
    for (int i = 0; i < manifest->n_tasks; i++) {
        author->answers[i].text = hole_of(manifest, &manifest->tasks[i], staged);
        n += author->answers[i].text != NULL;
    }
    author->is_given_up = n > 0 && !trial_ends(forms_of, &reading);
    if (author->is_given_up) {
        given_up_tell(author->entrant);
    } else {
        forms_of(&reading);
    }
    return n;
}

static void author_free(Author *author)
{
    for (int i = 0; i < MANIFEST_MAX_TASKS; i++) {
        free(author->answers[i].text);
        forms_free(&author->answers[i].forms);
    }
    *author = (Author){0};
}

// Is it a later attempt of the last author, or another version of it?
static int is_next_attempt(const HandedIn *class, const Entrant *entrant)
{
    const Entrant *last =
        class->n_authors > 0 ? class->authors[class->n_authors - 1].entrant : NULL;
    return last != NULL && (entrant->attempt > last->attempt || entrant->version > 1) &&
           strcmp(entrant->name, last->name) == 0 && strcmp(entrant->number, last->number) == 0;
}

// Read a staged entry, and note its author where it holds an answer.
static void entry_take(HandedIn *class, const Entrant *entrant, const char *staged)
{
    Author author = {.entrant = entrant};
    if (answers_read(class, staged, &author) == 0) {
        author_free(&author);
        class->n_without++;
    } else if (is_next_attempt(class, entrant)) {
        author_free(&class->authors[class->n_authors - 1]);
        class->authors[class->n_authors - 1] = author;
    } else {
        class->authors[class->n_authors++] = author;
    }
}

// ---- All entries -----------------------------------------------------------------------------

// Name an entry that cannot be read: the message before said why.
static void unread_note(HandedIn *class, const Entrant *entrant)
{
    char *label = line_clean(entrant->label);
    complain("copies: \"%s\" cannot be read, and is not compared", label);
    free(label);
    class->unread[class->n_unread++] = entrant;
}

// Stage an entry in a folder of its own, and take its answers. Returns 0, or -1 after one message.
static int entry_read(HandedIn *class, const Workdir *all, const char *folder,
                      const Entrant *entrant)
{
    char path[PATH_MAX], staged[PATH_MAX];
    char *message = NULL;
    Workdir workdir = *all;
    path_make(path, "%s/submissions/%s", folder, entrant->slug);
    path_make(workdir.folder, "%s/%s", all->folder, entrant->slug);
    path_make(staged, "%s/%s/staged", all->folder, entrant->slug);
    if (access(path, F_OK) != 0) {
        complain(
            "copies: %s: leads to nothing: the submission was moved or removed; give SUBMISSIONS=",
            path);
        return -1;
    }
    if (make_folder(workdir.folder) != 0 || make_closed_folder(staged) != 0) {
        return -1;
    }
    const int outcome = submission_stage(&workdir, path, staged, &message);
    free(message);  // the student reads it in the report
    if (outcome >= 0) {
        entry_take(class, entrant, staged);
    } else {
        unread_note(class, entrant);
    }
    if (folder_remove(workdir.folder) != 0) {
        return machine_fault(workdir.folder);
    }
    return 0;
}

static int entries_read(HandedIn *class, const Workdir *workdir, const char *folder)
{
    int result = 0;
    for (int i = 0; result == 0 && i < class->roster.n_entrants; i++) {
        const Entrant *entrant = &class->roster.entrants[i];
        if (entrant->is_link) {
            class->n_without++;
        } else {
            memory_reading(entrant->slug);
            result = entry_read(class, workdir, folder, entrant);
            memory_reading(NULL);
        }
    }
    if (result == 0 && class->n_unread > 0 && class->n_unread == class->roster.n_entrants) {
        complain("copies: %s/submissions: none of %d entries can be read", folder, class->n_unread);
        return -1;
    }
    return result;
}

static void scopes_read(HandedIn *class)
{
    for (int i = 0; i < class->manifest.n_tasks; i++) {
        const Task *task = &class->manifest.tasks[i];
        char *skeleton = skeleton_read(&class->manifest, task->file);
        if (skeleton != NULL) {
            class->scopes[i] = scope_names(skeleton, task->id);
        }
        free(skeleton);
    }
}

static int folder_clear(void *what)
{
    return folder_remove(what) == 0 || errno == ENOENT ? 0 : -1;
}

int handed_in_read(const char *build, const char *lab, const char *folder, HandedIn *class)
{
    char path[PATH_MAX];
    Workdir workdir = {.build = build, .manifest = &class->manifest};
    *class = (HandedIn){0};
    path_make(path, "%s/roster.json", folder);
    if (manifest_load(manifest_folder(lab), lab, &class->manifest) != 0 ||
        roster_load(path, &class->roster) != 0 ||
        settings_find_sandbox(NULL, &workdir.sandbox) != 0 ||
        sandbox_choose(workdir.sandbox, &workdir.sandbox) != 0) {
        return -1;
    }
    scopes_read(class);
    const size_t n_most = (size_t)class->roster.n_entrants + 1;
    class->authors = memory_take(n_most * sizeof *class->authors);
    class->unread = memory_take(n_most * sizeof *class->unread);
    if (temporary_folder_make(workdir.folder, "copies") != 0) {
        return machine_fault("no temporary folder in $TMPDIR or /tmp");
    }
    // The sandbox's user passes through it.
    int result = janitor_start(&workdir.janitor, folder_clear, workdir.folder) == 0
                     ? make_folder(workdir.folder)
                     : machine_fault("no process can be started");
    if (result == 0) {
        result = entries_read(class, &workdir, folder);
    }
    folder_clear(workdir.folder);
    janitor_dismiss(&workdir.janitor);
    return result;
}

void handed_in_free(HandedIn *class)
{
    for (int i = 0; i < class->n_authors; i++) {
        author_free(&class->authors[i]);
    }
    for (int i = 0; i < MANIFEST_MAX_TASKS; i++) {
        name_set_free(&class->scopes[i]);
    }
    free(class->authors);
    free(class->unread);
    roster_free(&class->roster);
    manifest_free(&class->manifest);
    *class = (HandedIn){0};
}
