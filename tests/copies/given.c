// Reading what the course gives (see given.h).
#include "given.h"

#include "form_list.h"
#include "holes.h"
#include "known_answer.h"
#include "path.h"
#include "skeleton.h"
#include "text_file.h"

#include <stdlib.h>
#include <string.h>
#include <unistd.h>

typedef struct Collection {
    Given *all;
    int n;
} Collection;

// Add the forms of a text, which may be NULL; so may the names around it.
static void text_add(Collection *given, const char *text, const NameSet *scope, int is_known)
{
    if (text == NULL) {
        return;
    }
    given->all = array_grow(given->all, given->n, sizeof *given->all);
    given->all[given->n++] = (Given){forms_read(text, scope), is_known};
}

static char *read_if_there(const char *path)
{
    return access(path, F_OK) == 0 ? text_file_read(path) : NULL;
}

static void holes_add(Collection *given, const Manifest *manifest, const Task *task,
                      const NameSet *scope)
{
    char path[PATH_MAX];
    char *skeleton = skeleton_read(manifest, task->file);
    path_make(path, "solutions/%s/%s", manifest->lab, task->file);
    char *solution = read_if_there(path);
    char *handed_out = skeleton != NULL ? hole_read(skeleton, task->id) : NULL;
    char *solved = solution != NULL ? hole_read(solution, task->id) : NULL;
    text_add(given, handed_out, scope, 0);
    text_add(given, solved, scope, 0);
    free(handed_out), free(solved), free(skeleton), free(solution);
}

// The fenced blocks of a page in Markdown.
static void page_add(Collection *given, const char *path)
{
    char *page = read_if_there(path);
    char *at = page;
    while (at != NULL && (at = strstr(at, "\n```")) != NULL) {
        char *begin = strchr(at + 1, '\n');
        char *end = begin != NULL ? strstr(begin, "\n```") : NULL;
        if (end == NULL) {
            break;
        }
        *end = '\0';
        text_add(given, begin, NULL, 0);
        at = strchr(end + 1, '\n');
    }
    free(page);
}

// Without the solution none can be read.
static void known_add(Collection *given, const Manifest *manifest, const NameSet *scopes)
{
    static KnownAnswers known;
    if (manifest_has_solution(manifest->lab)) {
        known_answers_read(&known, manifest);
    }
    for (int i = 0; i < known.n; i++) {
        const KnownAnswer *answer = &known.all[i];
        text_add(given, answer->text, &scopes[answer->task - manifest->tasks], 1);
    }
    known_answers_free(&known);
}

Given *given_read(const Manifest *manifest, const NameSet scopes[], int *n_given)
{
    Collection all = {0};
    char page[PATH_MAX];
    for (int i = 0; i < manifest->n_tasks; i++) {
        holes_add(&all, manifest, &manifest->tasks[i], &scopes[i]);
    }
    path_make(page, "labs/%s/README.md", manifest->lab);
    page_add(&all, page);
    known_add(&all, manifest, scopes);
    *n_given = all.n;
    return all.all;
}

void given_free(Given *given, int n_given)
{
    for (int i = 0; i < n_given; i++) {
        forms_free(&given[i].forms);
    }
    free(given);
}
