// The table of mistakes' kinds, and finding them in a message.
#include "mistake_kinds.h"

#include "complain.h"

#include <regex.h>
#include <stdlib.h>
#include <string.h>

const MistakeKind mistake_kinds[N_MISTAKE_KINDS] = {
    {"mirrored-x", "mirrored|turned upside down"},
    {"flipped-y", "flipped"},
    {"transposed", "transposed"},
    {"channels-swapped", "(red|green|blue) and (red|green|blue) swapped|its channels re?[rv]"},
    {"shifted-one", "shifted by one pixel"},
    {"shifted-half", "shifted by half a pixel"},
    {"gamma", "gamma"},
    {"strict-boundary", "strict where it should not be|touching counts"},
    {"later-of-equals", "two (equal|equally).* (circle|one) won|nearer is strict"},
    {"far-child", "far child were never"},
    {"missing-in-cell", "does not list it|is missing in its list|"
                        "(first|last) (circle|sphere) of (every|the) leaf (is|were) missing"},
    {"unwritten", "nobody wrote"},
};

int mistake_kind_find(const char *id)
{
    for (int kind = 0; kind < N_MISTAKE_KINDS; kind++) {
        if (strcmp(mistake_kinds[kind].id, id) == 0) {
            return kind;
        }
    }
    return -1;
}

// The expressions, compiled at the first use: thousands of messages are held against them.
static const regex_t *expressions(void)
{
    static regex_t compiled[N_MISTAKE_KINDS];
    static int are_compiled = 0;
    for (int kind = 0; !are_compiled && kind < N_MISTAKE_KINDS; kind++) {
        if (regcomp(&compiled[kind], mistake_kinds[kind].says,
                    REG_EXTENDED | REG_ICASE | REG_NOSUB) != 0) {
            complain("mistake_kinds: the expression of %s cannot be compiled",
                     mistake_kinds[kind].id);
            exit(2);
        }
    }
    are_compiled = 1;
    return compiled;
}

unsigned mistake_kinds_named(const char *message)
{
    unsigned named = 0;
    for (int kind = 0; kind < N_MISTAKE_KINDS; kind++) {
        named |= regexec(&expressions()[kind], message, 0, NULL, 0) == 0 ? 1u << kind : 0;
    }
    return named;
}
