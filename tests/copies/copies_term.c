// Adding the pairs of several labs (see copies_term.h).
#include "copies_term.h"

#include "form_list.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

// Those who write alike by chance or habit may do so in each lab.
static const double LEVEL_OF_A_LAB = 3;

// The author whom an entry of the gradebook stands for, or -1.
static int author_find(const HandedIn *class, const Entry *entry)
{
    for (int i = 0; entry != NULL && i < class->n_authors; i++) {
        if (strcmp(class->authors[i].entrant->slug, entry->id) == 0) {
            return i;
        }
    }
    return -1;
}

static void lab_pair_add(AlikeTerm *all, int *n, LabPair lab_pair)
{
    all->lab_pairs = array_grow(all->lab_pairs, *n, sizeof *all->lab_pairs);
    all->lab_pairs[(*n)++] = lab_pair;
}

// Add a lab's pairs for all persons that its authors are.
//   authors   [n_persons]: each person's author, or -1
static void lab_take(AlikeTerm *all, int lab, const int *authors, int *n)
{
    const Pairs *pairs = &all->labs[lab].pairs;
    for (int i = 0; i < pairs->n; i++) {
        const Pair *pair = &pairs->all[i];
        for (int p = 0; p < all->term.n_persons; p++) {
            for (int q = 0; authors[p] == pair->first && q < all->term.n_persons; q++) {
                if (authors[q] == pair->second) {
                    lab_pair_add(all, n,
                                 p < q ? (LabPair){p, q, lab, pair, 0}
                                       : (LabPair){q, p, lab, pair, 1});
                }
            }
        }
    }
}

static int lab_pairs_compare(const void *left, const void *right)
{
    const LabPair *a = left, *b = right;
    int order = a->first - b->first;
    order = order != 0 ? order : a->second - b->second;
    return order != 0 ? order : a->lab - b->lab;
}

static int term_pairs_compare(const void *left, const void *right)
{
    const TermPair *a = left, *b = right;
    const int order = (a->score < b->score) - (a->score > b->score);
    return order != 0 ? order : lab_pairs_compare(a->labs, b->labs);
}

// Put the pairs that are listed first, as in a lab (pairs.h). The others are dropped.
static void listed_choose(AlikeTerm *all)
{
    const int n_persons = all->term.n_persons;
    int *groups = groups_make(n_persons);
    for (int i = 0; i < all->n_pairs && all->n_listed < PAIRS_LISTED; i++) {
        const TermPair pair = all->pairs[i];
        if (pair.score >= all->level &&
            groups_connect(groups, n_persons, pair.labs->first, pair.labs->second)) {
            all->pairs[all->n_listed++] = pair;
        }
    }
    free(groups);
}

// Put together what belongs to the same two persons.
static void pairs_add_up(AlikeTerm *all, int n)
{
    if (n > 0) {
        qsort(all->lab_pairs, (size_t)n, sizeof *all->lab_pairs, lab_pairs_compare);
    }
    all->pairs = memory_take(((size_t)n + 1) * sizeof *all->pairs);
    for (int i = 0; i < n; i++) {
        const LabPair *lab_pair = &all->lab_pairs[i];
        const int is_new = i == 0 || lab_pair[-1].first != lab_pair->first ||
                           lab_pair[-1].second != lab_pair->second;
        if (is_new) {
            all->pairs[all->n_pairs++] = (TermPair){.labs = lab_pair};
        }
        TermPair *pair = &all->pairs[all->n_pairs - 1];
        pair->n_labs++;
        pair->score += lab_pair->pair->score;
    }
    qsort(all->pairs, (size_t)all->n_pairs, sizeof *all->pairs, term_pairs_compare);
    const double n_persons = all->term.n_persons;
    all->level = log(fmax(1, n_persons * (n_persons - 1) / 2)) + LEVEL_OF_A_LAB * all->term.n_labs;
    listed_choose(all);
}

int alike_term_read(const char *build, char *const *folders, int n_folders, AlikeTerm *all)
{
    int n = 0;
    *all = (AlikeTerm){0};
    if (term_load(folders, n_folders, &all->term) != 0 || term_join(&all->term) != 0) {
        return -1;
    }
    const Term *term = &all->term;
    int *authors = memory_take(((size_t)term->n_persons + 1) * sizeof *authors);
    all->labs = memory_take(((size_t)term->n_labs + 1) * sizeof *all->labs);
    int result = 0;
    for (int lab = 0; result == 0 && lab < term->n_labs; lab++) {
        result = alike_read(build, term->labs[lab].lab, term->labs[lab].folder, &all->labs[lab]);
        for (int p = 0; result == 0 && p < term->n_persons; p++) {
            authors[p] = author_find(&all->labs[lab].class, term->persons[p].entries[lab]);
        }
        if (result == 0) {
            lab_take(all, lab, authors, &n);
        }
    }
    if (result == 0) {
        pairs_add_up(all, n);
    }
    free(authors);
    return result;
}

void alike_term_free(AlikeTerm *all)
{
    for (int lab = 0; all->labs != NULL && lab < all->term.n_labs; lab++) {
        alike_free(&all->labs[lab]);
    }
    free(all->labs), free(all->lab_pairs), free(all->pairs);
    term_free(&all->term);
    *all = (AlikeTerm){0};
}
