// Comparing any two authors (see pairs.h), and all for a class (see alike.h).
#include "alike.h"

#include "form_list.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { PAIRS_ROOM = 8 * PAIRS_KEPT };

// Were forms independent of each other, the odds that a pair at the level shares its forms by
// chance would be 1 to e^CERTAINTY, for all pairs of the class together. They are not quite.
static const double CERTAINTY = 3;

static int ids_compare(const void *left, const void *right)
{
    const int *a = left, *b = right;
    return (*a > *b) - (*a < *b);
}

static void ids_collect(const HandedIn *class, const Author *author, const Weights *weights,
                        Ids *ids)
{
    int n = 0, n_once = 0;
    for (int t = 0; t < class->manifest.n_tasks; t++) {
        n += author->answers[t].forms.n;
    }
    *ids = (Ids){.all = memory_take(((size_t)n + 1) * sizeof *ids->all)};
    for (int t = 0; t < class->manifest.n_tasks; t++) {
        const Forms *forms = &author->answers[t].forms;
        for (int i = 0; i < forms->n; i++) {
            ids->all[ids->n++] = forms->all[i].id;
        }
    }
    qsort(ids->all, (size_t)n, sizeof *ids->all, ids_compare);
    for (int i = 0; i < n; i++) {
        if (n_once == 0 || ids->all[n_once - 1] != ids->all[i]) {
            ids->all[n_once++] = ids->all[i];
            ids->nats += weights->all[ids->all[i]].nats;
        }
    }
    ids->n = n_once;
}

static Pair pair_compare(const Ids *a, const Ids *b, const Weights *weights)
{
    Pair pair = {0};
    for (int i = 0, j = 0; i < a->n && j < b->n;) {
        if (a->all[i] == b->all[j]) {
            const Weight *weight = &weights->all[a->all[i]];
            pair.nats += weight->nats;
            pair.n_shared += weight->nats > 0;
            pair.n_only_two += weight->nats > 0 && weight->n_authors == 2;
            i++, j++;
        } else if (a->all[i] < b->all[j]) {
            i++;
        } else {
            j++;
        }
    }
    const double less = a->nats < b->nats ? a->nats : b->nats;
    pair.share = less > 0 ? pair.nats / less : 0;
    pair.score = pair.nats * pair.share;
    return pair;
}

// The most alike first; of equals in the roster's order.
static int pairs_compare(const void *left, const void *right)
{
    const Pair *a = left, *b = right;
    int order = (a->score < b->score) - (a->score > b->score);
    order = order != 0 ? order : a->first - b->first;
    return order != 0 ? order : a->second - b->second;
}

// Order the pairs, and forget all but the best.
static void pairs_cut(Pairs *pairs)
{
    qsort(pairs->all, (size_t)pairs->n, sizeof *pairs->all, pairs_compare);
    pairs->n = pairs->n < PAIRS_KEPT ? pairs->n : PAIRS_KEPT;
}

static void all_compare(const HandedIn *class, const Weights *weights, const Ids *ids, Pairs *pairs)
{
    for (int i = 0; i < class->n_authors; i++) {
        for (int j = i + 1; j < class->n_authors; j++) {
            Pair pair = pair_compare(&ids[i], &ids[j], weights);
            pair.first = i, pair.second = j;
            pairs->n_compared++;
            if (pair.n_shared > 0) {
                pairs->all[pairs->n++] = pair;
            }
            if (pairs->n == PAIRS_ROOM) {
                pairs_cut(pairs);
            }
        }
    }
    pairs_cut(pairs);
}

int *groups_make(int n)
{
    int *groups = memory_take(((size_t)n + 1) * sizeof *groups);
    for (int i = 0; i < n; i++) {
        groups[i] = i;
    }
    return groups;
}

int groups_connect(int *groups, int n, int first, int second)
{
    const int from = groups[second], to = groups[first];
    for (int i = 0; from != to && i < n; i++) {
        groups[i] = groups[i] == from ? to : groups[i];
    }
    return from != to;
}

// Put the pairs that are listed first.
static void listed_choose(const HandedIn *class, Pairs *pairs)
{
    Pair listed[PAIRS_LISTED] = {0};
    int *groups = groups_make(class->n_authors);
    int n_others = 0;
    for (int i = 0; i < pairs->n; i++) {
        const Pair pair = pairs->all[i];
        if (pair.score >= pairs->level && pairs->n_listed < PAIRS_LISTED &&
            groups_connect(groups, class->n_authors, pair.first, pair.second)) {
            listed[pairs->n_listed++] = pair;
        } else {
            pairs->all[PAIRS_KEPT + n_others++] = pair;  // there is room (PAIRS_ROOM)
        }
    }
    memmove(pairs->all + pairs->n_listed, pairs->all + PAIRS_KEPT,
            (size_t)n_others * sizeof *pairs->all);
    memcpy(pairs->all, listed, (size_t)pairs->n_listed * sizeof *pairs->all);
    free(groups);
}

// What is listed, and for whom the list would say something.
static void level_set(const HandedIn *class, Pairs *pairs)
{
    pairs->level = log(pairs->n_compared > 0 ? pairs->n_compared : 1) + CERTAINTY;
    listed_choose(class, pairs);
    for (int i = 0; i < class->n_authors; i++) {
        pairs->n_tellable += pairs->ids[i].nats >= pairs->level;
    }
}

void pairs_find(const HandedIn *class, const Weights *weights, Pairs *pairs)
{
    const size_t n = (size_t)class->n_authors;
    *pairs = (Pairs){.all = memory_take(PAIRS_ROOM * sizeof *pairs->all),
                     .ids = memory_take((n + 1) * sizeof *pairs->ids),
                     .n_authors = class->n_authors};
    for (size_t i = 0; i < n; i++) {
        ids_collect(class, &class->authors[i], weights, &pairs->ids[i]);
    }
    all_compare(class, weights, pairs->ids, pairs);
    level_set(class, pairs);
}

void pairs_free(Pairs *pairs)
{
    for (int i = 0; i < pairs->n_authors; i++) {
        free(pairs->ids[i].all);
    }
    free(pairs->all);
    free(pairs->ids);
    *pairs = (Pairs){0};
}

int pairs_are_too_few(const HandedIn *class, const Pairs *pairs)
{
    return class->n_authors < PAIRS_MIN_AUTHORS || 4 * pairs->n_tellable < class->n_authors;
}

int author_has(const Pairs *pairs, int author, int id)
{
    const Ids *ids = &pairs->ids[author];
    return bsearch(&id, ids->all, (size_t)ids->n, sizeof *ids->all, ids_compare) != NULL;
}

// ---- A class ---------------------------------------------------------------------------------

int alike_read(const char *build, const char *lab, const char *folder, Alike *alike)
{
    *alike = (Alike){0};
    if (handed_in_read(build, lab, folder, &alike->class) != 0) {
        return -1;
    }
    weights_make(&alike->class, &alike->weights);
    pairs_find(&alike->class, &alike->weights, &alike->pairs);
    return 0;
}

void alike_free(Alike *alike)
{
    pairs_free(&alike->pairs);
    weights_free(&alike->weights);
    handed_in_free(&alike->class);
}

int is_shared(const Alike *alike, const Pair *pair, int id)
{
    return alike->weights.all[id].nats > 0 && author_has(&alike->pairs, pair->first, id) &&
           author_has(&alike->pairs, pair->second, id);
}
