// A set of names, for which finding one stays quick however many there are.
#ifndef COPIES_NAME_SET_H
#define COPIES_NAME_SET_H

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
