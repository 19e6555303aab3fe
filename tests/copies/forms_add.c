// Telling forms apart while they are collected (see forms_parts.h).
#include "forms_parts.h"

#include "form_list.h"

#include <search.h>
#include <stdlib.h>
#include <string.h>

// A form, and how often it was there.
typedef struct Seen {
    FormKind kind;
    const char *text;  // the first one's
    int n;
} Seen;

static int seen_compare(const void *left, const void *right)
{
    const Seen *a = left, *b = right;
    const int order = (int)a->kind - (int)b->kind;
    return order != 0 ? order : strcmp(a->text, b->text);
}

// Is there room for the form? Notes it.
static int form_note(Forms *forms, FormKind kind, const char *text)
{
    const Seen key = {kind, text, 1};
    Seen **found = tfind(&key, &forms->seen, seen_compare);
    if (found != NULL) {
        return (*found)->n++ < FORM_PLACES;
    }
    if (forms->n_different >= FORMS_MAX) {
        forms->is_cut = 1;
        return 0;
    }
    Seen *seen = memory_take(sizeof *seen);
    *seen = key;
    if (tsearch(seen, &forms->seen, seen_compare) == NULL) {
        memory_end();
    }
    forms->n_different++;
    return 1;
}

void forms_add(Forms *forms, FormKind kind, char *text, int first_line, int last_line)
{
    if (text[0] == '\0' || !form_note(forms, kind, text)) {
        free(text);
        return;
    }
    forms->all = array_grow(forms->all, forms->n, sizeof *forms->all);
    forms->all[forms->n++] = (Form){kind, text, first_line, last_line, -1};
}

void forms_complete(Forms *forms)
{
    tdestroy(forms->seen, free);
    forms->seen = NULL;
}
