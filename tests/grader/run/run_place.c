// The notes of a probe (see run_place.h).
#include "run_place.h"

#include "folder.h"
#include "path.h"

#include <ctype.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

// The probe's files, below the folder that it writes to.
#define NOTE (PROBE_NOTE_PATH + sizeof "out")
#define ANSWERING (PROBE_ANSWERING_PATH + sizeof "out")

// More than all answers of a step.
#define MOST_BYTES ((size_t)64 << 20)

// Names are compared with their padding: one without an end is none.
static int is_named(const ProbeNote *note, const char *step)
{
    char name[SECTION_NAME_BYTES] = {0};
    memcpy(name, step, strlen(step));
    return memcmp(name, note->name, sizeof name) == 0;
}

RunPlace run_place_before(const ProbeNote *note)
{
    RunPlace place = {0};
    if (is_named(note, "")) {
        snprintf(place.where, sizeof place.where, "before any of your functions was called");
    } else if (is_named(note, PROBE_NOTE_BUILD)) {
        snprintf(place.where, sizeof place.where, "while your kernels were compiled");
    }
    return place;
}

int run_note_is_name(const ProbeNote *note)
{
    size_t n = 0;
    while (n < sizeof note->name &&
           (isalnum((unsigned char)note->name[n]) || note->name[n] == '_')) {
        n++;
    }
    if (n == 0 || n == sizeof note->name) {
        return 0;
    }
    char name[SECTION_NAME_BYTES] = {0};
    memcpy(name, note->name, n);
    return is_named(note, name);
}

// A file of the folder, to be read; -1 where there is none. *n_bytes receives its size.
static int file_open(const char *out, const char *name, size_t *n_bytes)
{
    char path[PATH_MAX];
    path_make(path, "%s/%s", out, name);
    return folder_file_open(AT_FDCWD, path, n_bytes);
}

// Which of n inputs was being tried: the one behind the last answer of which a bit is not set.
static uint32_t input_find(const char *out, uint32_t n)
{
    size_t n_bytes = 0, n_left;
    const int file = file_open(out, ANSWERING, &n_bytes);
    const size_t answer_bytes = n_bytes / n;
    unsigned char *answers = n_bytes > 0 && n_bytes <= MOST_BYTES ? malloc(n_bytes) : NULL;
    const int is_read = answers != NULL && answer_bytes * n == n_bytes &&
                        read(file, answers, n_bytes) == (ssize_t)n_bytes;
    for (n_left = is_read ? n_bytes : 0; n_left > 0 && answers[n_left - 1] == 0xff;) {
        n_left--;
    }
    const size_t n_answered = is_read ? (n_left + answer_bytes - 1) / answer_bytes : n;
    free(answers);
    if (file >= 0) {
        close(file);
    }
    return n_answered < n ? (uint32_t)n_answered : PROBE_NO_INPUT;
}

ProbeNote run_note_load(const char *out)
{
    ProbeNote note;
    size_t n_bytes;
    const int file = file_open(out, NOTE, &n_bytes);
    const int is_whole =
        file >= 0 && n_bytes == sizeof note && read(file, &note, sizeof note) == sizeof note;
    if (file >= 0) {
        close(file);
    }
    if (!is_whole) {
        return (ProbeNote){.name = "?"};
    }
    if (note.input == PROBE_NO_INPUT && note.n_together > 0) {
        note.input = input_find(out, note.n_together);
    }
    return note;
}
