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
#include <strings.h>

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

// ---- The systems' patterns -------------------------------------------------------------------

// Moodle: "NAME_NUMBER_assignsubmission_KIND_...", and without a number for those who are in no
// team. Where the pattern stands twice, a student has put it into a name or a file's: then nobody
// can tell where the name ends. Returns the length of the name, or 0.
static int read_moodle(const char *entry, EntryName *name)
{
    static const char pattern[] = "_assignsubmission_";
    const char *plugin = strstr(entry, pattern);
    name->system = plugin != NULL ? SYSTEM_MOODLE : SYSTEM_NONE;
    if (plugin == NULL || strstr(plugin + 1, pattern) != NULL) {
        return 0;
    }
    const char *digits = plugin;
    while (digits > entry && isdigit((unsigned char)digits[-1])) {
        digits--;
    }
    const int n_digits = (int)(plugin - digits);
    const int has_number =
        n_digits > 0 && n_digits < ENTRY_NUMBER_BYTES && digits > entry && digits[-1] == '_';
    const int length = (int)(has_number ? digits - 1 - entry : plugin - entry);
    if (length > 0) {
        snprintf(name->number, sizeof name->number, "%.*s", has_number ? n_digits : 0, digits);
        name->is_text = strncmp(plugin, "_assignsubmission_onlinetext", 28) == 0;
        const char *file = strchr(plugin + strlen(pattern), '_');
        name->file = file != NULL && file[1] != '\0' ? (int)(file + 1 - entry) : 0;
    }
    return length;
}

// Gradescope: "submission_NUMBER"; the number is a submission's, the name stays as it is.
static void read_gradescope(const char *entry, int length, EntryName *name)
{
    const char *digits = entry + strlen("submission_");
    if (strncmp(entry, "submission_", strlen("submission_")) == 0) {
        const int n_digits = (int)strspn(digits, "0123456789");
        if (n_digits > 0 && n_digits < ENTRY_NUMBER_BYTES && digits + n_digits == entry + length) {
            snprintf(name->number, sizeof name->number, "%.*s", n_digits, digits);
        }
    }
}

// GitHub Classroom: "lab-03-USER". Returns the length of what stands before the user's name, or 0.
static int read_github(const char *entry, int lab_number)
{
    if (strncasecmp(entry, "lab", 3) != 0) {
        return 0;
    }
    const char *digits = entry + 3 + (entry[3] == '-' || entry[3] == '_');
    char *end;
    if (!isdigit((unsigned char)digits[0]) || strtol(digits, &end, 10) != lab_number ||
        (end[0] != '-' && end[0] != '_') || end[1] == '\0') {
        return 0;
    }
    return (int)(end + 1 - entry);
}

size_t entry_name_number_length(const char *file)
{
    const size_t n_digits = file[0] == '[' ? strspn(file + 1, "0123456789") : 0;
    return n_digits > 0 && strncmp(file + 1 + n_digits, "]_", 2) == 0 ? n_digits + 3 : 0;
}

EntryName entry_name_read(const char *entry, int lab_number)
{
    EntryName name = {0};
    int begin = 0;
    int end = read_moodle(entry, &name);
    if (end == 0) {
        end = archive_stem_length(entry);
        end = end > 0 ? end : (int)strlen(entry);
        begin = read_github(entry, lab_number) + (int)entry_name_number_length(entry);
        begin = begin < end ? begin : 0;
        read_gradescope(entry, end, &name);
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
