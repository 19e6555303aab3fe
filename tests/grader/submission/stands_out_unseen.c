// Looking for characters that nobody sees (see stands_out.h).
#include "stands_out.h"

#include "source_words.h"
#include "utf8.h"

#include <inttypes.h>

typedef struct OddSign {
    uint32_t character;
    const char *name, *advice;
} OddSign;

static const OddSign *odd_sign_find(uint32_t character)
{
    static const char space[] = "type a space there", none[] = "delete it";
    static const OddSign signs[] = {
        {0x00A0, "a no-break space", space},
        {0x00AD, "a soft hyphen", none},
        {0x037E, "a Greek question mark", "type a semicolon there"},
        {0x2007, "a figure space", space},
        {0x200B, "a zero-width space", none},
        {0x200C, "a zero-width non-joiner", none},
        {0x200D, "a zero-width joiner", none},
        {0x200E, "a left-to-right mark", none},
        {0x200F, "a right-to-left mark", none},
        {0x2013, "a dash", "type a minus there"},
        {0x2018, "a curly quotation mark", "type a straight one there"},
        {0x2019, "a curly quotation mark", "type a straight one there"},
        {0x201C, "a curly quotation mark", "type a straight one there"},
        {0x201D, "a curly quotation mark", "type a straight one there"},
        {0x2028, "a line separator", "begin a new line there"},
        {0x2029, "a paragraph separator", "begin a new line there"},
        {0x202F, "a narrow no-break space", space},
        {0x2060, "a word joiner", none},
        {0x2212, "a typographic minus", "type a minus there"},
        {0x3000, "an ideographic space", space},
        {0xFEFF, "a byte order mark", none},
    };
    for (size_t i = 0; i < sizeof signs / sizeof *signs; i++) {
        if (signs[i].character == character) {
            return &signs[i];
        }
    }
    return NULL;
}

int stands_out_unseen(const char *name, const char *text, FILE *notes)
{
    enum { MOST_SHOWN = 4 };
    int n_found = 0;
    SourceReader reader = source_reader(text);
    for (SourceWord word = source_next(&reader); word.kind != SOURCE_END;
         word = source_next(&reader)) {
        // A byte that is no ASCII counts as one of a name.
        for (size_t at = 0; word.kind == SOURCE_NAME && at < word.length;) {
            uint32_t character = 0;
            const int n_bytes = utf8_read(word.start + at, &character);
            const OddSign *sign = n_bytes > 0 ? odd_sign_find(character) : NULL;
            // Compilers pass over a mark at the very beginning.
            const int is_first = word.start + at == text && character == 0xFEFF;
            if (sign != NULL && !is_first && n_found++ < MOST_SHOWN) {
                fprintf(notes, "%s:%d: %s, U+%04" PRIX32 ", which looks like something else: %s\n",
                        name, word.line, sign->name, character, sign->advice);
            }
            at += n_bytes > 0 ? (size_t)n_bytes : 1;
        }
    }
    if (n_found > MOST_SHOWN) {
        fprintf(notes, "%s: and %d more such characters\n", name, n_found - MOST_SHOWN);
    }
    return n_found;
}
