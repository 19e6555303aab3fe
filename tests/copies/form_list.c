// Texts put together to forms (see form_list.h).
#include "form_list.h"

#include "complain.h"
#include "message.h"

#include <search.h>
#include <stdlib.h>
#include <string.h>

static const char *what_is_read;

void memory_reading(const char *what)
{
    what_is_read = what;
}

_Noreturn void memory_end(void)
{
    if (what_is_read != NULL) {
        complain("copies: out of memory while reading \"%s\": remove this entry, and start again",
                 what_is_read);
    } else {
        complain("copies: out of memory");
    }
    exit(2);
}

void *memory_take(size_t n_bytes)
{
    void *memory = calloc(1, n_bytes);
    if (memory == NULL) {
        memory_end();
    }
    return memory;
}

void *array_grow(void *array, int n, size_t n_bytes)
{
    if (n > 0 && (n & (n - 1)) != 0) {
        return array;  // it has room up to the next power of two
    }
    void *moved = realloc(array, (n == 0 ? 1 : 2 * (size_t)n) * n_bytes);
    if (moved == NULL) {
        memory_end();
    }
    return moved;
}

void form_list_add(FormList *list, char *item)
{
    list->items = array_grow(list->items, list->n, sizeof *list->items);
    list->items[list->n++] = item;
}

static int items_compare(const void *left, const void *right)
{
    return strcmp(*(char *const *)left, *(char *const *)right);
}

char *form_list_text(const char *name, FormList *list, int is_sorted)
{
    size_t n_bytes = strlen(name) + sizeof "()";
    if (is_sorted && list->n > 1) {
        qsort(list->items, (size_t)list->n, sizeof *list->items, items_compare);
    }
    for (int i = 0; i < list->n; i++) {
        n_bytes += strlen(list->items[i]) + 1;
    }
    char *form = memory_take(n_bytes);
    char *end = stpcpy(stpcpy(form, name), "(");
    for (int i = 0; i < list->n; i++) {
        end = stpcpy(stpcpy(end, i > 0 ? "," : ""), list->items[i]);
        free(list->items[i]);
    }
    stpcpy(end, ")");
    free(list->items);
    *list = (FormList){0};
    return form;
}

char *form_list_bare(FormList *list)
{
    if (list->n != 1) {
        return form_list_text("", list, 0);
    }
    char *only = list->items[0];
    free(list->items);
    *list = (FormList){0};
    return only;
}

char *form_of(const char *name, char *first, char *second, int is_sorted)
{
    FormList list = {0};
    form_list_add(&list, first);
    if (second != NULL) {
        form_list_add(&list, second);
    }
    return form_list_text(name, &list, is_sorted);
}

// ---- Sets of names ---------------------------------------------------------------------------

static int names_compare(const void *left, const void *right)
{
    return strcmp(left, right);
}

int name_set_add(NameSet *set, const char *name)
{
    if (name_set_has(set, name)) {
        return 0;
    }
    if (tsearch(message_new("%s", name), &set->root, names_compare) == NULL) {
        memory_end();
    }
    set->n++;
    return 1;
}

int name_set_has(const NameSet *set, const char *name)
{
    return tfind(name, &set->root, names_compare) != NULL;
}

void name_set_free(NameSet *set)
{
    tdestroy(set->root, free);
    *set = (NameSet){0};
}
