// The notes of a probe (see run_place.h).
#include "run_place.h"

#include <ctype.h>
#include <fcntl.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

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

ProbeNote run_note_load(const char *path)
{
    ProbeNote note;
    struct stat status;
    const int file = open(path, O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_NOCTTY | O_CLOEXEC);
    const int is_whole = file >= 0 && fstat(file, &status) == 0 && S_ISREG(status.st_mode) &&
                         status.st_size == sizeof note &&
                         read(file, &note, sizeof note) == sizeof note;
    if (file >= 0) {
        close(file);
    }
    return is_whole ? note : (ProbeNote){.name = "?"};
}
