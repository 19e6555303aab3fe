// Any bytes as a file that was handed in: its words stand in it, one after the other; what stands
// out is short; and what a hole is filled with is found again.
#include "fuzz.h"

#include "holes.h"
#include "source_words.h"
#include "stands_out.h"

#include <stdio.h>

static void check_words(const char *source)
{
    const char *end = source + strlen(source);
    const char *behind = source;
    SourceReader reader = source_reader(source);
    int line = 1, n_outside = 0, n_words;
    SourceWord word = source_next(&reader);
    for (; word.kind != SOURCE_END; word = source_next(&reader)) {
        MUST_HOLD(word.start >= behind && word.length > 0 &&
                  word.length <= (size_t)(end - word.start));
        MUST_HOLD(word.line >= line && strlen(word.text) <= word.length);
        behind = word.start + word.length;
        line = word.line;
        n_outside += !word.in_directive;
    }
    MUST_HOLD(source_next(&reader).kind == SOURCE_END && reader.text == end);
    SourceWord *words = source_words(source, &n_words);
    MUST_HOLD(words != NULL && n_words == n_outside);
    free(words);
}

static void check_notes(const char *source)
{
    char *notes = NULL;
    size_t n_bytes;
    FILE *file = open_memstream(&notes, &n_bytes);
    const int n_notes = stands_out_in_text("a.c", source, file);
    fclose(file);
    MUST_HOLD(n_notes >= 0 && n_notes <= 8 && n_bytes <= 2000);
    free(notes);
}

static void check_holes(const char *source)
{
    char id[HOLE_ID_BYTES];
    for (int i = 0; i < 4 && hole_id(source, i, id); i++) {
        char *content = hole_read(source, id);
        char *filled = hole_fill(source, id, "mine\n");
        MUST_HOLD((content == NULL) == (filled == NULL));
        char *own = filled != NULL ? hole_read(filled, id) : NULL;
        MUST_HOLD(filled == NULL || (own != NULL && strcmp(own, "mine\n") == 0));
        free(own);
        free(filled);
        free(content);
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t n_bytes)
{
    char *source = calloc(1, n_bytes + 1);
    MUST_HOLD(source != NULL);
    memcpy(source, bytes, n_bytes);
    check_words(source);
    check_notes(source);
    check_holes(source);
    free(source);
    return 0;
}
