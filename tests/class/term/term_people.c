// Whose entries are whose, across the labs of a term (see term.h). Read next: term_csv.c.
//
// Entries of one person are a set; each set is known by one of them, its root.
#include "term.h"

#include "complain.h"

#include <stdlib.h>
#include <string.h>
#include <strings.h>

static int root_of(const Term *term, int entry)
{
    while (term->entries[entry].person != entry) {
        entry = term->entries[entry].person;
    }
    return entry;
}

static void unite(Term *term, int a, int b)
{
    const int first = root_of(term, a), second = root_of(term, b);
    // The earlier one stays, so that the order of joining plays no part.
    if (first < second) {
        term->entries[second].person = first;
    } else {
        term->entries[first].person = second;
    }
}

// ---- Keys ------------------------------------------------------------------------------------

static int addresses_compare(const void *left, const void *right)
{
    const Entry *const *a = left, *const *b = right;
    const int order = strcasecmp((*a)->address, (*b)->address);
    return order != 0 ? order : (*a > *b) - (*a < *b);
}

static int numbers_compare(const void *left, const void *right)
{
    const Entry *const *a = left, *const *b = right;
    const int order = strcasecmp((*a)->id_number, (*b)->id_number);
    return order != 0 ? order : (*a > *b) - (*a < *b);
}

static int names_compare(const void *left, const void *right)
{
    const Entry *const *a = left, *const *b = right;
    const int order = strcmp((*a)->name, (*b)->name);
    return order != 0 ? order : (*a > *b) - (*a < *b);
}

// The entries that may be joined. Returns how many.
static int order_make(const Term *term, const Entry **order)
{
    int n = 0;
    for (int i = 0; i < term->n_entries; i++) {
        if (term->entries[i].alone == NULL) {
            order[n++] = &term->entries[i];
        }
    }
    return n;
}

static void keys_join(Term *term, const Entry **order, int by_address)
{
    const int n = order_make(term, order);
    qsort(order, (size_t)n, sizeof *order, by_address ? addresses_compare : numbers_compare);
    for (int i = 1; i < n; i++) {
        const Entry *a = order[i - 1], *b = order[i];
        const char *left = by_address ? a->address : a->id_number;
        const char *right = by_address ? b->address : b->id_number;
        if (left[0] != '\0' && strcasecmp(left, right) == 0) {
            unite(term, (int)(a - term->entries), (int)(b - term->entries));
        }
    }
}

// Where one lab has two entries of a set nobody can say which counts: all of it comes apart.
//   has_lab   room for a mark for each lab of each set
static void doubles_part(Term *term, char *has_lab)
{
    const int n = term->n_entries;
    memset(has_lab, 0, (size_t)n * (size_t)term->n_labs);
    for (int i = 0; i < n; i++) {
        const int root = root_of(term, i);
        char *has = &has_lab[(size_t)root * (size_t)term->n_labs + (size_t)term->entries[i].lab];
        if (*has) {
            term->entries[root].alone = "one lab has this address or number twice";
        }
        *has = 1;
    }
    for (int i = 0; i < n; i++) {
        const Entry *root = &term->entries[root_of(term, i)];
        if (root->alone != NULL) {
            term->entries[i].alone = root->alone;
        }
    }
    for (int i = 0; i < n; i++) {
        if (term->entries[i].alone != NULL) {
            term->entries[i].person = i;
        }
    }
}

// ---- Names -----------------------------------------------------------------------------------

// May all sets that have one of these entries be one person's? No two entries of one lab, and no
// two addresses, or numbers, of sets that no key has joined.
static int is_one_person(const Term *term, const Entry *const *order, int begin, int end,
                         char *is_wanted)
{
    char has_lab[TERM_MAX_LABS] = {0};
    int address_of = -1, number_of = -1;
    int is_one = 1;
    memset(is_wanted, 0, (size_t)term->n_entries);
    for (int i = begin; i < end; i++) {
        is_wanted[root_of(term, (int)(order[i] - term->entries))] = 1;
    }
    for (int i = 0; i < term->n_entries; i++) {
        const Entry *entry = &term->entries[i];
        const int root = root_of(term, i);
        if (!is_wanted[root]) {
            continue;
        }
        is_one = is_one && !has_lab[entry->lab];
        has_lab[entry->lab] = 1;
        if (entry->address[0] != '\0') {
            is_one = is_one && (address_of < 0 || address_of == root);
            address_of = root;
        }
        if (entry->id_number[0] != '\0') {
            is_one = is_one && (number_of < 0 || number_of == root);
            number_of = root;
        }
    }
    return is_one;
}

// Join the sets of a name, order[begin] to order[end - 1], or mark these entries as twins.
static void name_join(Term *term, const Entry *const *order, int begin, int end, char *is_wanted)
{
    const int first = root_of(term, (int)(order[begin] - term->entries));
    int is_joined = 1;
    for (int i = begin; i < end; i++) {
        is_joined &= root_of(term, (int)(order[i] - term->entries)) == first;
    }
    if (is_joined || order[begin]->name[0] == '\0') {
        return;
    }
    const int is_one = is_one_person(term, order, begin, end, is_wanted);
    for (int i = begin; i < end; i++) {
        const int index = (int)(order[i] - term->entries);
        if (is_one) {
            unite(term, index, first);
        } else {
            term->entries[index].is_twin = 1;
        }
    }
}

static void names_join(Term *term, const Entry **order, char *is_wanted)
{
    const int n = order_make(term, order);
    qsort(order, (size_t)n, sizeof *order, names_compare);
    for (int begin = 0, end; begin < n; begin = end) {
        end = begin + 1;
        while (end < n && strcmp(order[end]->name, order[begin]->name) == 0) {
            end++;
        }
        name_join(term, order, begin, end, is_wanted);
    }
}

// ---- Rows ------------------------------------------------------------------------------------

static int persons_compare(const void *left, const void *right)
{
    const Person *a = left, *b = right;
    int order = strcmp(a->name, b->name);
    order = order != 0 ? order : strcmp(a->address, b->address);
    order = order != 0 ? order : strcmp(a->id_number, b->id_number);
    return order != 0 ? order : (a->entries > b->entries) - (a->entries < b->entries);
}

static void entry_enter(const Term *term, const Entry *entry, Person *person)
{
    person->entries[entry->lab] = entry;
    person->name = person->name != NULL ? person->name : entry->name;
    person->address =
        person->address != NULL && person->address[0] != '\0' ? person->address : entry->address;
    person->id_number = person->id_number != NULL && person->id_number[0] != '\0'
                            ? person->id_number
                            : entry->id_number;
    person->sum += entry->has_score ? entry->score : 0;
    person->n_passed += entry->has_score && entry->score >= term->pass;
    person->n_open += entry->open != NULL;
    if (entry->alone != NULL) {
        person->note = entry->alone;
    } else if (entry->is_twin) {
        person->note = "not joined with another row of this name";
    }
}

static int persons_make(Term *term)
{
    const size_t n = (size_t)term->n_entries + 1;
    int *row_of = calloc(n, sizeof *row_of);
    term->persons = calloc(n, sizeof *term->persons);
    term->cells = calloc(n * (size_t)(term->n_labs + 1), sizeof *term->cells);
    if (row_of == NULL || term->persons == NULL || term->cells == NULL) {
        free(row_of);
        return -1;
    }
    for (int i = 0; i < term->n_entries; i++) {
        const int root = root_of(term, i);
        if (root == i) {
            row_of[i] = term->n_persons++;
            term->persons[row_of[i]].entries = term->cells + row_of[i] * term->n_labs;
        }
        entry_enter(term, &term->entries[i], &term->persons[row_of[root]]);
    }
    qsort(term->persons, (size_t)term->n_persons, sizeof *term->persons, persons_compare);
    free(row_of);
    return 0;
}

int term_join(Term *term)
{
    const size_t n = (size_t)term->n_entries + 1;
    const Entry **order = malloc(n * sizeof *order);
    char *marks = malloc(n * (size_t)(term->n_labs + 1));
    int failed = order == NULL || marks == NULL;
    if (!failed) {
        for (int i = 0; i < term->n_entries; i++) {
            term->entries[i].person = i;
        }
        keys_join(term, order, 1);
        keys_join(term, order, 0);
        doubles_part(term, marks);
        names_join(term, order, marks);
        failed = persons_make(term) != 0;
    }
    free(order), free(marks);
    if (failed) {
        complain("term: out of memory");
    }
    return failed ? -1 : 0;
}

const char *term_admission(const Term *term, const Person *person)
{
    return person->n_passed >= term->need                    ? "yes"
           : person->n_passed + person->n_open >= term->need ? "open"
                                                             : "no";
}

TermCount term_count(const Term *term, int lab)
{
    TermCount count = {0};
    for (int i = 0; i < term->n_persons; i++) {
        const Entry *entry = term->persons[i].entries[lab];
        if (entry != NULL && entry->has_score) {
            count.n_scores++;
            count.n_passed += entry->score >= term->pass;
            count.mean += entry->score;
        }
    }
    count.mean = count.n_scores > 0 ? count.mean / count.n_scores : 0;
    return count;
}
