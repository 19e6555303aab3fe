// What a name looks like (see name_likeness.h).
//
// What is mistaken for what is the Unicode consortium's knowledge, and ICU has it: confusables
// (uspoof.h), capitals, compatible and invisible characters (NFKC case folding), names. Used by
// look_alikes.c and owners.c.
#include "name_likeness.h"

#include "complain.h"
#include "utf8.h"

#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unicode/uchar.h>
#include <unicode/unorm2.h>
#include <unicode/uscript.h>
#include <unicode/uspoof.h>
#include <unicode/ustring.h>
#include <unicode/utf8.h>

// No character looks like more than some twenty others, an Arabic ligature of a whole sentence.
enum { LOOKS_MAX = 64, KEY_MAX = 4 * LOOKS_MAX };

// Write what a character looks like, in small letters. Capitals are compared as such before they
// are folded, as they look like others than their small letters; what they are folded to is
// compared once more. Returns how many UTF-16 units.
static int looks_find(UChar32 code, UChar looks[LOOKS_MAX])
{
    static USpoofChecker *confusables;  // opened at the first name, and needed to the end
    UErrorCode status = U_ZERO_ERROR;
    const UNormalizer2 *folding = unorm2_getNFKCCasefoldInstance(&status);
    confusables = confusables != NULL ? confusables : uspoof_open(&status);
    UChar folded[LOOKS_MAX];
    int n = 0;
    U16_APPEND_UNSAFE(folded, n, code);
    n = uspoof_getSkeleton(confusables, 0, folded, n, looks, LOOKS_MAX, &status);
    n = unorm2_normalize(folding, looks, n, folded, LOOKS_MAX, &status);
    n = uspoof_getSkeleton(confusables, 0, folded, n, looks, LOOKS_MAX, &status);
    if (U_FAILURE(status)) {
        complain("gradebook: no table of letters that look alike: %s", u_errorName(status));
        exit(EXIT_FAILURE);
    }
    return n;
}

// The Latin letter that a character is a kind of, by its name: "LATIN LETTER SMALL CAPITAL A",
// "LATIN SMALL LETTER A REVERSED-SCHWA", "NEGATIVE CIRCLED LATIN CAPITAL LETTER A". 0 for none.
static char latin_letter(UChar32 code)
{
    char name[128] = "";
    UErrorCode status = U_ZERO_ERROR;
    u_charName(code, U_UNICODE_CHAR_NAME, name, sizeof name, &status);
    char *word = strstr(name, "LATIN ");
    for (word = word != NULL ? strtok(word, " ") : NULL; word != NULL; word = strtok(NULL, " ")) {
        if (strlen(word) == 1) {
            return (char)tolower((unsigned char)word[0]);
        }
    }
    return 0;
}

// Is it a part of a name? Not what cannot be seen, nor punctuation, nor accents that any letter may
// have: some systems write "ü" as "u" and two dots.
static int is_counted(UChar32 code)
{
    UErrorCode status = U_ZERO_ERROR;
    const uint32_t category = U_GET_GC_MASK(code);
    const int is_accent =
        (category & U_GC_M_MASK) != 0 && uscript_getScript(code, &status) == USCRIPT_INHERITED;
    return !character_is_blank((uint32_t)code) && !is_accent &&
           (category & (U_GC_L_MASK | U_GC_N_MASK | U_GC_M_MASK | U_GC_SO_MASK)) != 0;
}

// Write what a character adds to a key. Returns how many bytes.
static int key_find(UChar32 code, char key[KEY_MAX])
{
    UChar looks[LOOKS_MAX];
    const int n_looks = looks_find(code, looks);
    int n = 0;
    for (int i = 0; i < n_looks;) {
        UChar32 look;
        U16_NEXT(looks, i, n_looks, look);
        const char letter = is_counted(look) ? latin_letter(look) : 0;
        if (letter != 0) {
            key[n++] = letter == 'i' ? 'l' : letter;
        } else if (is_counted(look)) {
            U8_APPEND_UNSAFE(key, n, look);
        }
    }
    return n;
}

// The same, of most letters of most names looked up: a class's names are compared with all of a
// worksheet's, and ICU takes microseconds for each.
static int key_look_up(uint32_t code, char key[KEY_MAX])
{
    enum { N_KEPT = 0x250 };  // Latin letters
    static struct {
        int is_there, n;
        char key[KEY_MAX];
    } kept[N_KEPT];
    if (code >= N_KEPT) {
        return key_find((UChar32)code, key);
    }
    if (!kept[code].is_there) {
        kept[code].n = key_find((UChar32)code, kept[code].key);
        kept[code].is_there = 1;
    }
    memcpy(key, kept[code].key, (size_t)kept[code].n);
    return kept[code].n;
}

// "\x0A" stands for a byte that cannot be shown (entry_name.h).
static int is_escape(const char *text)
{
    return text[0] == '\\' && text[1] == 'x' && isxdigit((unsigned char)text[2]) &&
           isxdigit((unsigned char)text[3]);
}

void name_likeness(const char *name, char key[ENTRY_NAME_BYTES])
{
    int n = 0;
    while (*name != '\0') {
        if (is_escape(name)) {
            name += 4;
            continue;
        }
        uint32_t code = 0xFFFD;  // what is not UTF-8
        const int length = utf8_read(name, &code);
        name += length > 0 ? length : 1;
        char own[KEY_MAX];
        const int n_own = key_look_up(code, own);
        if (n + n_own >= ENTRY_NAME_BYTES) {
            break;
        }
        memcpy(key + n, own, (size_t)n_own);
        n += n_own;
    }
    key[n] = '\0';
}

int name_stem(const char *name)
{
    const int whole = (int)strlen(name);
    int end = whole;
    while (end > 0 && (name[end - 1] == ' ' || name[end - 1] == '.')) {
        end--;
    }
    const int in_brackets = end > 0 && name[end - 1] == ')';
    int begin = end - in_brackets;
    while (begin > 0 && isdigit((unsigned char)name[begin - 1])) {
        begin--;
    }
    // A year or a student's number is no attempt.
    const int n_digits = end - in_brackets - begin;
    if (n_digits < 1 || n_digits > 2 || begin < 2) {
        return whole;
    }
    const char before = name[begin - 1];
    if (in_brackets ? before != '(' : before != '-' && before != '_' && before != ' ') {
        return whole;
    }
    begin--;
    while (begin > 1 && name[begin - 1] == ' ') {
        begin--;
    }
    return begin;
}

int name_looks_like(const char *name, const char *other)
{
    char keys[2][ENTRY_NAME_BYTES], stem[ENTRY_NAME_BYTES];
    name_likeness(other, keys[1]);
    if (keys[1][0] == '\0') {
        return 0;
    }
    name_likeness(name, keys[0]);
    if (strcmp(keys[0], keys[1]) == 0) {
        return 1;
    }
    snprintf(stem, sizeof stem, "%.*s", name_stem(name), name);
    name_likeness(stem, keys[0]);
    return strcmp(keys[0], keys[1]) == 0;
}

void name_compose(const char *name, char composed[ENTRY_NAME_BYTES])
{
    UErrorCode status = U_ZERO_ERROR;
    UChar units[ENTRY_NAME_BYTES], composed_units[ENTRY_NAME_BYTES];
    int n;
    u_strFromUTF8(units, ENTRY_NAME_BYTES, &n, name, -1, &status);
    n = unorm2_normalize(unorm2_getNFCInstance(&status), units, n, composed_units, ENTRY_NAME_BYTES,
                         &status);
    u_strToUTF8(composed, ENTRY_NAME_BYTES, NULL, composed_units, n, &status);
    if (U_FAILURE(status) || status == U_STRING_NOT_TERMINATED_WARNING) {
        snprintf(composed, ENTRY_NAME_BYTES, "%s", name);  // too long, or no text
    }
}

int character_is_blank(uint32_t code)
{
    // Of all patterns of Braille this one has no dot; Unicode calls it a symbol.
    enum { BRAILLE_BLANK = 0x2800 };
    const UChar32 character = (UChar32)code;
    return code == BRAILLE_BLANK || u_isUWhiteSpace(character) ||
           u_hasBinaryProperty(character, UCHAR_DEFAULT_IGNORABLE_CODE_POINT) ||
           (U_GET_GC_MASK(character) & (U_GC_C_MASK | U_GC_Z_MASK)) != 0;
}
