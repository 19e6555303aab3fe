// Grouping rows by what their names look like (see look_alikes.h). Read next: name_likeness.h.
#include "look_alikes.h"

#include "complain.h"
#include "name_likeness.h"

#include <stdlib.h>
#include <string.h>

// A row under the name that it seems to have.
typedef struct Seen {
    char *key;
    const Row *row;
} Seen;

static int keys_compare(const void *left, const void *right)
{
    return strcmp(((const Seen *)left)->key, ((const Seen *)right)->key);
}

static int seen_compare(const void *left, const void *right)
{
    const Seen *a = left;
    const Seen *b = right;
    const int order = keys_compare(a, b);
    return order != 0 ? order : (a->row > b->row) - (a->row < b->row);
}

static int groups_compare(const void *left, const void *right)
{
    const LookAlike *a = left;
    const LookAlike *b = right;
    return (a->rows[0] > b->rows[0]) - (a->rows[0] < b->rows[0]);
}

// Put the key of "carol" in the place of that of "carol-2", and of "carol-2 (2)", where `all`,
// sorted by their keys, has a "carol". Returns 0, or -1 when memory runs out.
static int attempt_fold(const Seen *all, int n_all, Seen *seen)
{
    char stem[ENTRY_NAME_BYTES], key[ENTRY_NAME_BYTES];
    snprintf(stem, sizeof stem, "%s", seen->row->entrant->name);
    for (;;) {
        const int length = name_stem(stem);
        if (stem[length] == '\0') {
            return 0;
        }
        stem[length] = '\0';
        name_likeness(stem, key);
        const Seen wanted = {.key = key};
        if (bsearch(&wanted, all, (size_t)n_all, sizeof *all, keys_compare) == NULL) {
            continue;
        }
        free(seen->key);
        seen->key = strdup(key);
        if (seen->key == NULL) {
            return -1;
        }
    }
}

// The keys of all rows, sorted; names of which nothing is left to see are left out. Returns how
// many, or -1 when memory runs out.
static int keys_make(const Gradebook *gradebook, Seen *seen)
{
    char key[ENTRY_NAME_BYTES];
    int n = 0;
    for (int i = 0; i < gradebook->n_rows; i++) {
        name_likeness(gradebook->rows[i].entrant->name, key);
        if (key[0] != '\0') {
            seen[n] = (Seen){strdup(key), &gradebook->rows[i]};
            if (seen[n++].key == NULL) {
                return -1;
            }
        }
    }
    qsort(seen, (size_t)n, sizeof *seen, seen_compare);
    return n;
}

// From rows sorted by their keys to groups.
static void groups_make(const Seen *seen, int n, LookAlikes *look_alikes)
{
    const Row **rows = look_alikes->rows;
    for (int begin = 0, end; begin < n; begin = end) {
        LookAlike group = {.rows = rows};
        int all_exact = 1;
        for (end = begin; end < n && keys_compare(&seen[begin], &seen[end]) == 0; end++) {
            rows[group.n_rows++] = seen[end].row;
            all_exact = all_exact && seen[end].row->entrant->is_exact &&
                        seen[end].row->entrant->version == 0;
        }
        if (group.n_rows > 1 && !all_exact) {
            look_alikes->groups[look_alikes->n_groups++] = group;
            rows += group.n_rows;
        }
    }
    qsort(look_alikes->groups, (size_t)look_alikes->n_groups, sizeof *look_alikes->groups,
          groups_compare);
}

static void seen_free(Seen *seen, int n)
{
    for (int i = 0; seen != NULL && i < n; i++) {
        free(seen[i].key);
    }
    free(seen);
}

int look_alikes_find(const Gradebook *gradebook, LookAlikes *look_alikes)
{
    const size_t n_most = (size_t)gradebook->n_rows + 1;
    *look_alikes = (LookAlikes){.groups = calloc(n_most, sizeof *look_alikes->groups),
                                .rows = calloc(n_most, sizeof *look_alikes->rows)};
    Seen *all = calloc(n_most, sizeof *all);
    Seen *folded = calloc(n_most, sizeof *folded);
    int failed =
        look_alikes->groups == NULL || look_alikes->rows == NULL || all == NULL || folded == NULL;
    const int n = failed ? 0 : keys_make(gradebook, all);
    failed = failed || n < 0 || keys_make(gradebook, folded) < 0;
    for (int i = 0; i < n && !failed; i++) {
        failed = attempt_fold(all, n, &folded[i]) != 0;
    }
    if (!failed) {
        qsort(folded, (size_t)n, sizeof *folded, seen_compare);
        groups_make(folded, n, look_alikes);
    }
    seen_free(all, gradebook->n_rows);
    seen_free(folded, gradebook->n_rows);
    if (failed) {
        complain("gradebook: out of memory");
        look_alikes_free(look_alikes);
    }
    return failed ? -1 : 0;
}

void look_alikes_free(LookAlikes *look_alikes)
{
    free(look_alikes->groups);
    free(look_alikes->rows);
    *look_alikes = (LookAlikes){0};
}
