// Numbering and weighing forms (see weights.h).
#include "weights.h"

#include "form_list.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

// A form that the known answers have is half as telling; so are names and blanks.
static const double KNOWN_SHARE = 0.5, SMALL_SHARE = 0.5;

enum { OF_KNOWN = -1, OF_COURSE = -2 };

// A form, and whose it is: an author's number, or one of the two above.
typedef struct Owned {
    Form *form;
    int owner;
} Owned;

static int owned_compare(const void *left, const void *right)
{
    const Owned *a = left, *b = right;
    int order = (int)a->form->kind - (int)b->form->kind;
    order = order != 0 ? order : strcmp(a->form->text, b->form->text);
    return order != 0 ? order : a->owner - b->owner;
}

static int is_alike(const Form *a, const Form *b)
{
    return a->kind == b->kind && strcmp(a->text, b->text) == 0;
}

static int forms_own(Forms *forms, int owner, Owned *owned, int n)
{
    for (int i = 0; owned != NULL && i < forms->n; i++) {
        owned[n + i] = (Owned){&forms->all[i], owner};
    }
    return n + forms->n;
}

// Put all forms into a list; with NULL they are only counted. Returns how many.
static int all_own(HandedIn *class, const Weights *weights, Owned *owned)
{
    int n = 0;
    for (int i = 0; i < class->n_authors; i++) {
        for (int t = 0; t < class->manifest.n_tasks; t++) {
            n = forms_own(&class->authors[i].answers[t].forms, i, owned, n);
        }
    }
    for (int i = 0; i < weights->n_given; i++) {
        Given *given = &weights->given[i];
        n = forms_own(&given->forms, given->is_known ? OF_KNOWN : OF_COURSE, owned, n);
    }
    return n;
}

// Note that an owner has a form. Owners come in their order.
static void owner_note(Weight *weight, int owner, int last_owner)
{
    weight->is_given |= owner == OF_COURSE;
    weight->is_known |= owner == OF_KNOWN;
    weight->n_authors += owner >= 0 && owner != last_owner;
}

static void number_all(Weights *weights, Owned *owned, int n)
{
    for (int i = 0; i < n; i++) {
        const int is_new = i == 0 || !is_alike(owned[i - 1].form, owned[i].form);
        if (is_new) {
            weights->all[weights->n++] = (Weight){.form = owned[i].form};
        }
        owned[i].form->id = weights->n - 1;
        owner_note(&weights->all[weights->n - 1], owned[i].owner,
                   is_new ? OF_COURSE : owned[i - 1].owner);
    }
}

static double nats_of(const Weight *weight, int n_authors)
{
    if (weight->is_given || weight->n_authors == 0) {
        return 0;
    }
    return log((double)n_authors / weight->n_authors) * (weight->is_known ? KNOWN_SHARE : 1) *
           (weight->form->kind >= FORM_NAME ? SMALL_SHARE : 1);
}

void weights_make(HandedIn *class, Weights *weights)
{
    *weights = (Weights){0};
    weights->given = given_read(&class->manifest, class->scopes, &weights->n_given);
    const int n = all_own(class, weights, NULL);
    Owned *owned = memory_take(((size_t)n + 1) * sizeof *owned);
    weights->all = memory_take(((size_t)n + 1) * sizeof *weights->all);
    all_own(class, weights, owned);
    qsort(owned, (size_t)n, sizeof *owned, owned_compare);
    number_all(weights, owned, n);
    free(owned);
    for (int i = 0; i < weights->n; i++) {
        weights->all[i].nats = nats_of(&weights->all[i], class->n_authors);
    }
}

void weights_free(Weights *weights)
{
    given_free(weights->given, weights->n_given);
    free(weights->all);
    *weights = (Weights){0};
}
