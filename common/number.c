// Numbers from text (see number.h).
//
// It is the first to touch what a user typed. Read next: scene2d_csv.c.
#include "number.h"

#include <errno.h>
#include <locale.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static int is_digits(const char *text)
{
    return text[0] != '\0' && strspn(text, "0123456789") == strlen(text);
}

int number_read_integer(const char *text, int64_t lowest, int64_t highest, int64_t *value)
{
    // strtoll() skips spaces and takes a plus sign; a user who typed those typed something else.
    if (!is_digits(text + (text[0] == '-'))) {
        return -1;
    }
    errno = 0;
    long long number = strtoll(text, NULL, 10);
    if (errno != 0 || number < lowest || number > highest) {
        return -1;
    }
    *value = number;
    return 0;
}

int number_read_unsigned(const char *text, uint64_t lowest, uint64_t highest, uint64_t *value)
{
    if (!is_digits(text)) {
        return -1;
    }
    errno = 0;
    unsigned long long number = strtoull(text, NULL, 10);
    if (errno != 0 || number < lowest || number > highest) {
        return -1;
    }
    *value = number;
    return 0;
}

// strtof() follows the locale of the thread. A library that sets it to one with a decimal comma
// must not change what a scene file means, so it runs under the "C" locale.
static locale_t locale_enter(void)
{
    static locale_t c_locale = (locale_t)0;
    if (c_locale == (locale_t)0) {
        c_locale = newlocale(LC_ALL_MASK, "C", (locale_t)0);
    }
    return uselocale(c_locale);
}

int number_read_float(const char *text, float *value)
{
    // strtof() alone would also take "nan", "infinity", "0x10" and leading spaces.
    if (text[0] == '\0' || strspn(text, "+-.0123456789eE") != strlen(text)) {
        return -1;
    }
    locale_t caller_locale = locale_enter();
    char *end = NULL;
    float number = strtof(text, &end);
    uselocale(caller_locale);
    if (*end != '\0' || !isfinite(number)) {
        return -1;
    }
    *value = number;
    return 0;
}
