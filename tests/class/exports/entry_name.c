// The names that course systems give to what students hand in (see entry_name.h).
//
// A name is chosen by a student or by a stranger: it is only ever compared, shown and made into a
// slug, never a part of a path or a command. Read next: roster.c.
#include "entry_name.h"

#include "clean_text.h"
#include "contents.h"
#include "utf8.h"

#include <ctype.h>
#include <nettle/sha2.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

// How long the readable part of a slug gets, and how much of a digest follows it: enough that
// nobody finds a name for another's slug, which would be another's results.
enum { SLUG_WORDS = 40, SLUG_DIGEST_BYTES = 8 };

// ---- Bytes that can be shown -----------------------------------------------------------------

// The length of the character at text when it is valid UTF-8 that can be shown in one line and has
// one meaning, or 0.
static int shown_length(const char *text)
{
    uint32_t code;
    const int length = utf8_read(text, &code);
    return length > 0 && code != '\\' && !character_is_unseen(code) ? length : 0;
}

void entry_name_show(const char *bytes, size_t n_bytes, char text[ENTRY_NAME_BYTES])
{
    char copy[256];
    size_t n = 0;
    snprintf(copy, sizeof copy, "%.*s", (int)n_bytes, bytes);
    for (const char *at = copy; *at != '\0' && n + 5 < ENTRY_NAME_BYTES;) {
        const int length = shown_length(at);
        if (length > 0) {
            memcpy(text + n, at, (size_t)length);
            n += (size_t)length;
            at += length;
        } else {
            n += (size_t)snprintf(text + n, 5, "\\x%02X", (unsigned char)*at++);
        }
    }
    text[n] = '\0';
}

// ---- Names -------------------------------------------------------------------------------------

EntryName entry_name_read(const char *entry, int lab_number)
{
    EntryName name = {0};
    int begin = 0;
    int end = moodle_name_read(entry, &name);
    if (end == 0) {
        end = archive_stem_length(entry);
        end = end > 0 ? end : (int)strlen(entry);
        begin = git_prefix_length(entry, lab_number) + (int)studip_number_length(entry);
        begin = begin < end ? begin : 0;
        gradescope_name_read(entry, end, &name);
    }
    entry_name_show(entry + begin, (size_t)(end - begin), name.name);
    return name;
}

static void part_show(NamePart part, char *text)
{
    entry_name_show(part.text != NULL ? part.text : "", part.length, text);
}

EntryName entry_name_read_export(const char *entry, int is_folder, ExportSystem system)
{
    EntryName name = {0};
    const SystemName found = system_name_read(entry, system);
    if (found.system == SYSTEM_NONE || (found.file.length == 0) != is_folder ||
        found.number.length >= sizeof name.number) {
        return name;
    }
    part_show(found.name, name.name);
    part_show(found.login, name.login);
    snprintf(name.number, sizeof name.number, "%.*s", (int)found.number.length,
             found.number.length > 0 ? found.number.text : "");
    snprintf(name.time, sizeof name.time, "%s", found.time);
    name.system = found.system;
    name.file = is_folder ? 0 : (int)(found.file.text - entry);
    name.is_text = found.is_note;
    name.is_late = found.is_late;
    return name;
}

// ---- Slugs -----------------------------------------------------------------------------------

void entry_name_slug(const char *name, const char *entry, char slug[ENTRY_SLUG_BYTES])
{
    int n = 0;
    for (; *name != '\0' && n < SLUG_WORDS; name++) {
        const unsigned char letter = (unsigned char)*name;
        if (letter < 0x80 && isalnum(letter)) {
            slug[n++] = (char)tolower(letter);
        } else if (n > 0 && slug[n - 1] != '-') {
            slug[n++] = '-';
        }
    }
    if (n > 0 && slug[n - 1] != '-') {
        slug[n++] = '-';
    }
    unsigned char digest[SLUG_DIGEST_BYTES];
    struct sha256_ctx hash;
    sha256_init(&hash);
    sha256_update(&hash, strlen(entry), (const unsigned char *)entry);
    sha256_digest(&hash, sizeof digest, digest);
    for (int i = 0; i < SLUG_DIGEST_BYTES; i++, n += 2) {
        snprintf(slug + n, 3, "%02x", digest[i]);
    }
}
