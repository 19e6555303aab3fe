// What every fuzz target needs: properties that must hold, the messages of a reader, and bytes as a
// file.
//
// A target is a file fuzz_NAME.c with the one function below. libFuzzer calls it with bytes that it
// varies towards new branches of the code (README.md here says how); tests/unit/test_corpus.c calls
// it with the bytes that did so before, under the name fuzz_NAME.
#ifndef FUZZ_FUZZ_H
#define FUZZ_FUZZ_H

#include "clean_text.h"

#include <ftw.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t n_bytes);

// Stop at once when what should hold does not. The sanitizers, and libFuzzer, then show the input.
#define MUST_HOLD(condition)                                                                       \
    do {                                                                                           \
        if (!(condition)) {                                                                        \
            fprintf(stdout, "%s:%d: does not hold: %s\n", __FILE__, __LINE__, #condition);         \
            fflush(stdout);                                                                        \
            abort();                                                                               \
        }                                                                                          \
    } while (0)

// ---- Messages -------------------------------------------------------------------------------

// What went to stderr between a begin and an end.
typedef struct Messages {
    FILE *real_stderr;
    char *text;
    size_t length;
} Messages;

static inline void messages_begin(Messages *messages)
{
    messages->real_stderr = stderr;
    stderr = open_memstream(&messages->text, &messages->length);  // glibc's stderr is a variable
    MUST_HOLD(stderr != NULL);
}

// Is there nothing in a text that moves a terminal?
static inline int is_showable(const char *text)
{
    char *clean = text_clean(text, TEXT_IN_LINES);
    const int is_clean = strcmp(clean, text) == 0;
    free(clean);
    return is_clean;
}

// At most one line, and in it nothing that moves a terminal. free() the text.
static inline void messages_end(Messages *messages)
{
    fclose(stderr);
    stderr = messages->real_stderr;
    const char *text = messages->text;
    MUST_HOLD(strlen(text) == messages->length && is_showable(text));
    MUST_HOLD(strcspn(text, "\n") + 1 == messages->length || messages->length == 0);
}

// ---- Bytes as a file ------------------------------------------------------------------------

// A folder of its own with the bytes in the file lab/lab.json, and an empty folder "out".
typedef struct InputFile {
    char folder[64];
    char path[96];  // of the file
    char out[96];
} InputFile;

static inline void input_file_make(const uint8_t *bytes, size_t n_bytes, InputFile *input)
{
    // In memory where there is such a place: a fuzzer makes thousands a second.
    strcpy(input->folder, "/dev/shm/fuzz-XXXXXX");
    if (mkdtemp(input->folder) == NULL) {
        strcpy(input->folder, "/tmp/fuzz-XXXXXX");
        MUST_HOLD(mkdtemp(input->folder) != NULL);
    }
    snprintf(input->path, sizeof input->path, "%s/lab", input->folder);
    snprintf(input->out, sizeof input->out, "%s/out", input->folder);
    MUST_HOLD(mkdir(input->path, 0700) == 0 && mkdir(input->out, 0700) == 0);
    snprintf(input->path, sizeof input->path, "%s/lab/lab.json", input->folder);
    FILE *file = fopen(input->path, "wb");
    MUST_HOLD(file != NULL && fwrite(bytes, 1, n_bytes, file) == n_bytes && fclose(file) == 0);
}

static inline int input_entry_remove(const char *path, const struct stat *status, int kind,
                                     struct FTW *position)
{
    (void)status, (void)kind, (void)position;
    return remove(path);
}

static inline void input_file_remove(const InputFile *input)
{
    MUST_HOLD(nftw(input->folder, input_entry_remove, 16, FTW_DEPTH | FTW_PHYS) == 0);
}

#endif
