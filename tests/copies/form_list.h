// Texts put together to forms, sets of names, and arrays that grow. Whatever finds no memory ends
// the program after one message: an instructor starts it anew, and nothing is lost.
#ifndef COPIES_FORM_LIST_H
#define COPIES_FORM_LIST_H

#include <stddef.h>

// End the program because no memory is left, after one message. memory_reading() says what was read
// then (an entry, fit to be shown, which must live on), or NULL.
void memory_reading(const char *what);
_Noreturn void memory_end(void);

// Room for one more element behind n: the array, perhaps moved. n_bytes: of one element.
void *array_grow(void *array, int n, size_t n_bytes);

// Memory that is all zeros.
void *memory_take(size_t n_bytes);

// Operands of one operator, or arguments. Start with {0}.
typedef struct FormList {
    char **items;  // each owned
    int n;
} FormList;

// Takes the item over.
void form_list_add(FormList *list, char *item);

// "name(item,item)", sorted or in their order; free() it. Releases the list.
char *form_list_text(const char *name, FormList *list, int is_sorted);

// The only item as it is; of none or several "(item,item)". free() it. Releases the list.
char *form_list_bare(FormList *list);

// "name(first,second)"; takes both over. second: NULL for none.
char *form_of(const char *name, char *first, char *second, int is_sorted);

// A set of names, for which finding one stays quick however many there are.
// Start with {0}; release with name_set_free().
typedef struct NameSet {
    void *root;
    int n;
} NameSet;

// Add a copy of the name. Returns 1, or 0 if it is there already. Running out of memory ends the
// program.
int name_set_add(NameSet *set, const char *name);
int name_set_has(const NameSet *set, const char *name);
void name_set_free(NameSet *set);

#endif
