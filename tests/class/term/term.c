// Reading the gradebooks of a term (see term.h). Read next: term_people.c.
#include "term.h"

#include "complain.h"
#include "path.h"

#include <jansson.h>
#include <stdlib.h>
#include <string.h>

static int fault(const char *path, const char *what)
{
    complain("term: %s: %s", path, what);
    return -1;
}

// ---- Entries ---------------------------------------------------------------------------------

// The text of a member, or "" where there is none.
static const char *text_of(const json_t *object, const char *key)
{
    const char *text = json_string_value(json_object_get(object, key));
    return text != NULL ? text : "";
}

// Room for one more entry. NULL: memory ran out.
static Entry *entry_add(Term *term)
{
    const int is_power = (term->n_entries & (term->n_entries - 1)) == 0;
    if (is_power) {
        const size_t n = term->n_entries == 0 ? 1 : 2 * (size_t)term->n_entries;
        Entry *entries = realloc(term->entries, n * sizeof *entries);
        if (entries == NULL) {
            return NULL;
        }
        term->entries = entries;
    }
    return &term->entries[term->n_entries++];
}

// Add an entry of a row of the gradebook for one of its owners, or for `whose` itself.
static int entry_take(Term *term, int lab, const json_t *whose, const json_t *row,
                      const char *alone)
{
    Entry *entry = entry_add(term);
    if (entry == NULL) {
        return -1;
    }
    const char *status = text_of(row, "status");
    const json_t *score = json_object_get(row, "score");
    *entry = (Entry){.lab = lab,
                     .id = text_of(row, "id"),
                     .name = text_of(whose, "name"),
                     .address = text_of(whose, "address"),
                     .id_number = text_of(whose, "id_number"),
                     .has_score = json_is_integer(score),
                     .score = (int)json_integer_value(score),
                     .alone = alone};
    if (strcmp(status, "not graded") == 0 || strcmp(status, "not entered") == 0) {
        entry->open = status;
    } else if (json_object_get(json_object_get(row, "late"), "unknown") != NULL) {
        entry->open = "to be decided by you";
    }
    return 0;
}

// The entries of a row: one for each owner, and one of its own for what is nobody's for certain.
static int row_take(Term *term, int lab, const json_t *row)
{
    const json_t *owners = json_object_get(row, "owners");
    const json_t *not_entered = json_object_get(row, "not_entered");
    int failed = 0;
    size_t i;
    json_t *owner;
    if (!json_is_true(json_object_get(row, "counts"))) {
        return 0;  // of an earlier attempt
    }
    json_array_foreach(owners, i, owner)
    {
        failed |= entry_take(term, lab, owner, row, NULL);
    }
    if (json_array_size(owners) == 0 || not_entered != NULL) {
        failed |=
            entry_take(term, lab, row, row, not_entered != NULL ? "to be decided by you" : NULL);
    }
    return failed;
}

// ---- Gradebooks ------------------------------------------------------------------------------

// What is wrong with a row, or NULL.
static const char *row_fault(const json_t *row, int max_score)
{
    const json_t *score = json_object_get(row, "score");
    const json_int_t points = json_integer_value(score);
    if (!json_is_string(json_object_get(row, "name")) ||
        !json_is_string(json_object_get(row, "status"))) {
        return "found a row without name or status: not a gradebook.json";
    }
    if (!json_is_boolean(json_object_get(row, "counts")) ||
        !json_is_array(json_object_get(row, "owners"))) {
        return "of an older version: run make grade-class for it again";
    }
    if (score != NULL && (!json_is_integer(score) || points < 0 || points > max_score)) {
        return "found a score that is no number of points of the lab";
    }
    return NULL;
}

// What is wrong with a gradebook, or NULL.
static const char *gradebook_fault(const TermLab *lab)
{
    const json_t *rows = json_object_get(lab->json, "students");
    const json_t *max_score = json_object_get(lab->json, "max_score");
    size_t i;
    json_t *row;
    if (!json_is_array(rows) || !json_is_integer(max_score)) {
        return "no list \"students\": not a gradebook.json";
    }
    if (lab->lab == NULL) {
        return "nothing was graded there: leave this folder out";
    }
    if (!json_is_array(json_object_get(lab->json, "without"))) {
        return "of an older version: run make grade-class for it again";
    }
    if (json_integer_value(max_score) < 1 || json_integer_value(max_score) > 1000000) {
        return "found a greatest score that is none";
    }
    json_array_foreach(rows, i, row)
    {
        const char *what = row_fault(row, lab->max_score);
        if (what != NULL) {
            return what;
        }
    }
    return NULL;
}

static int gradebook_read(const char *folder, TermLab *lab)
{
    char path[PATH_MAX];
    json_error_t error;
    path_make(path, "%s/gradebook.json", folder);
    lab->folder = folder;
    lab->json = json_load_file(path, JSON_REJECT_DUPLICATES, &error);
    if (lab->json == NULL) {
        return fault(path, error.text);
    }
    lab->lab = json_string_value(json_object_get(lab->json, "lab"));
    lab->max_score = (int)json_integer_value(json_object_get(lab->json, "max_score"));
    const char *what = gradebook_fault(lab);
    return what != NULL ? fault(path, what) : 0;
}

static int labs_compare(const void *left, const void *right)
{
    const TermLab *a = left, *b = right;
    const int order = strcmp(a->lab, b->lab);
    return order != 0 ? order : strcmp(a->folder, b->folder);
}

// One folder a lab: of two it would be unknown which score counts.
static int labs_check(const Term *term)
{
    for (int i = 1; i < term->n_labs; i++) {
        if (strcmp(term->labs[i - 1].lab, term->labs[i].lab) == 0) {
            complain("term: found %s in %s and in %s, expected one folder for each lab",
                     term->labs[i].lab, term->labs[i - 1].folder, term->labs[i].folder);
            return -1;
        }
    }
    return 0;
}

static int entries_read(Term *term)
{
    int failed = 0;
    for (int lab = 0; lab < term->n_labs; lab++) {
        const json_t *json = term->labs[lab].json;
        size_t i;
        json_t *row;
        json_array_foreach(json_object_get(json, "students"), i, row)
        {
            failed |= row_take(term, lab, row);
        }
        json_array_foreach(json_object_get(json, "without"), i, row)
        {
            failed |= entry_take(term, lab, row, row, NULL);
        }
        term->max_sum += term->labs[lab].max_score;
    }
    return failed ? fault(term->labs[0].folder, "out of memory") : 0;
}

int term_load(char *const *folders, int n_folders, Term *term)
{
    *term = (Term){0};
    if (n_folders > TERM_MAX_LABS) {
        complain("term: found %d folders, expected %d at most", n_folders, TERM_MAX_LABS);
        return -1;
    }
    for (int i = 0; i < n_folders; i++) {
        if (gradebook_read(folders[i], &term->labs[term->n_labs++]) != 0) {
            return -1;
        }
    }
    qsort(term->labs, (size_t)term->n_labs, sizeof *term->labs, labs_compare);
    return labs_check(term) != 0 ? -1 : entries_read(term);
}

void term_free(Term *term)
{
    for (int i = 0; i < term->n_labs; i++) {
        json_decref(term->labs[i].json);
    }
    free(term->entries), free(term->persons), free(term->cells);
    *term = (Term){0};
}
