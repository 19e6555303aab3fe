// A balanced tree of names (see name_set.h).
#include "name_set.h"

#include "form_list.h"
#include "message.h"

#include <search.h>
#include <stdlib.h>
#include <string.h>

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
