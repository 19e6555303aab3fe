// Reading a class and comparing its answers (see alike.h).
#include "alike.h"

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
