// Reading moments, with strptime() for all that is in numbers or English (see moment.h).
//
// No mktime(): in the hour that a clock shows twice it answers by what it was asked before.
#include "moment.h"

#include "path.h"

#include <ctype.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

// ---- Zones -------------------------------------------------------------------------------------

// "+01:00" for the environment's TZ, where POSIX counts to the west. Returns 0, or -1 for any other
// text.
static int offset_to_tz(const char *zone, char tz[32])
{
    struct tm tm = {0};
    const char *end = strchr("+-", zone[0]) != NULL ? strptime(zone, "%z", &tm) : NULL;
    if (end == NULL || *end != '\0' || strlen(zone) > 6) {
        return -1;
    }
    const int minutes = abs((int)tm.tm_gmtoff / 60);
    if (minutes > 14 * 60) {
        return -1;
    }
    const char *signs = tm.tm_gmtoff < 0 ? "-+" : "+-";
    snprintf(tz, 32, "<UTC%c%02d%02d>%c%d:%02d", signs[0], minutes / 60, minutes % 60, signs[1],
             minutes / 60, minutes % 60);
    return 0;
}

// A file of the zone database, by a name that leads nowhere else.
static int is_known_zone(const char *zone)
{
    char path[PATH_MAX];
    static const char signs[] =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_+-/";
    path_make(path, "/usr/share/zoneinfo/%s", zone);
    return zone[0] != '/' && strspn(zone, signs) == strlen(zone) &&
           (strcmp(zone, "UTC") == 0 || (strchr(zone, '/') != NULL && access(path, R_OK) == 0));
}

int moment_zone_set(const char *zone)
{
    char tz[32];
    if (zone == NULL) {
        unsetenv("TZ");
    } else if (offset_to_tz(zone, tz) == 0) {
        setenv("TZ", tz, 1);
    } else if (is_known_zone(zone)) {
        setenv("TZ", zone, 1);
    } else {
        return -1;
    }
    tzset();
    return 0;
}

// ---- Reading -----------------------------------------------------------------------------------

// English for a German name of a month, or the word as it is; NULL for one that is no month.
static const char *month_of(const char *word)
{
    static const char *const others[][2] = {
        {"Januar", "January"},    {"Februar", "February"}, {"März", "March"},
        {"Mär", "March"},         {"Mrz", "March"},        {"Maerz", "March"},
        {"Ma\u0308rz", "March"},  {"Mai", "May"},          {"Juni", "June"},
        {"Juli", "July"},         {"Okt", "October"},      {"Oktober", "October"},
        {"Dezember", "December"}, {"Dez", "December"},
    };
    for (size_t i = 0; i < sizeof others / sizeof *others; i++) {
        if (strcmp(word, others[i][0]) == 0) {
            return others[i][1];
        }
    }
    struct tm tm;
    const char *end = strptime(word, "%B", &tm);
    return end != NULL && *end == '\0' ? word : NULL;
}

// How long is what parts words here: a blank, also one that does not break (U+00A0, U+202F), a
// comma, or the point of a German day? A point between digits parts nothing.
static size_t gap_length(const char *text)
{
    if (strncmp(text, "\u00a0", 2) == 0) {
        return 2;
    }
    if (strncmp(text, "\u202f", 3) == 0) {
        return 3;
    }
    const int is_gap =
        *text == ' ' || *text == ',' || (*text == '.' && !isdigit((unsigned char)text[1]));
    return is_gap ? 1 : 0;
}

// The words of a moment with one blank between them, months in English, the day of the week left
// out. Returns 0, or -1 where that is too long for one.
static int words_arrange(const char *text, char words[64])
{
    size_t n = 0;
    for (size_t gap; *text != '\0';) {
        while ((gap = gap_length(text)) > 0) {
            text += gap;
        }
        char word[32];
        size_t length = 0;
        while (*text != '\0' && gap_length(text) == 0 && length < sizeof word - 1) {
            word[length++] = *text++;
        }
        word[length] = '\0';
        const int is_number = strpbrk(word, "0123456789") != NULL;
        const char *month = is_number ? NULL : month_of(word);
        const int is_weekday = !is_number && month == NULL && n == 0;
        if (length == 0 || is_weekday) {
            continue;
        }
        const char *shown = month != NULL ? month : word;
        if (n + strlen(shown) + 2 > 64) {
            return -1;
        }
        n += (size_t)sprintf(words + n, "%s%s", n > 0 ? " " : "", shown);
    }
    words[n] = '\0';
    return 0;
}

// What may follow the seconds: a part of one, and a zone. Is there nothing else?
static int tail_read(const char *tail, struct tm *tm, int *has_offset)
{
    if (*tail == '.') {
        tail += 1 + strspn(tail + 1, "0123456789");
    }
    tail += *tail == ' ';
    tail = strcmp(tail, "UTC") == 0 ? "Z" : tail;
    if (*tail == '\0') {
        return 1;
    }
    *has_offset = 1;
    const char *end = strchr("+-Z", *tail) != NULL ? strptime(tail, "%z", tm) : NULL;
    return end != NULL && *end == '\0';
}

enum { DAY = 24 * 60 * 60 };

// The moment at which the clock shows this. It is found by the offsets of the day before and the
// day after: between them a clock is changed at most once. Of an hour that it shows twice both fit,
// of one that it leaves out neither does: then the earlier moment counts.
static time_t moment_of_clock(struct tm tm)
{
    const time_t as_utc = timegm(&tm);
    time_t moments[2];
    int fits[2];
    for (int i = 0; i < 2; i++) {
        const time_t near = as_utc + (i == 0 ? -DAY : DAY);
        struct tm there;
        const long offset = localtime_r(&near, &there)->tm_gmtoff;
        moments[i] = as_utc - offset;
        fits[i] = localtime_r(&moments[i], &there)->tm_gmtoff == offset;
    }
    const int second = fits[0] == fits[1] ? moments[1] < moments[0] : fits[1];
    return moments[second];
}

static int form_read(const char *words, const char *form, time_t *moment)
{
    struct tm tm = {0};
    int has_offset = 0;
    const char *tail = strptime(words, form, &tm);
    if (tail == NULL || !tail_read(tail, &tm, &has_offset)) {
        return -1;
    }
    // The 30th of February becomes another day.
    const int day = tm.tm_mday;
    const long offset = tm.tm_gmtoff;
    struct tm plain = tm;
    const time_t utc = timegm(&plain) - offset;
    *moment = has_offset ? utc : moment_of_clock(tm);
    return plain.tm_mday == day && tm.tm_year >= 70 ? 0 : -1;
}

int moment_read(const char *text, time_t *moment)
{
    static const char *const forms[] = {
        "%Y-%m-%d %H:%M:%S", "%Y-%m-%d %H:%M",    "%Y-%m-%dT%H:%M:%S", "%Y-%m-%dT%H:%M",
        "%Y-%m-%d-%H-%M-%S", "%Y-%m-%d-%H-%M",    "%Y%m%d%H%M%S",      "%d.%m.%Y %H:%M:%S",
        "%d.%m.%Y %H:%M",    "%d %B %Y %I:%M %p", "%B %d %Y %I:%M %p", "%d %B %Y %H:%M",
        "%B %d %Y %H:%M",
    };
    char words[64];
    if (words_arrange(text, words) != 0) {
        return -1;
    }
    for (size_t i = 0; i < sizeof forms / sizeof *forms; i++) {
        if (form_read(words, forms[i], moment) == 0) {
            return 0;
        }
    }
    return -1;
}

time_t moment_later(time_t moment, long n, long unit)
{
    struct tm tm;
    if (unit % DAY != 0) {
        return moment + n * unit;
    }
    localtime_r(&moment, &tm);
    tm.tm_mday += (int)(n * (unit / DAY));
    return moment_of_clock(tm);
}

static void moment_format(time_t moment, const char *format, char text[MOMENT_BYTES])
{
    struct tm tm;
    localtime_r(&moment, &tm);
    if (strftime(text, MOMENT_BYTES, format, &tm) == 0) {
        text[0] = '\0';
    }
}

void moment_write(time_t moment, char text[MOMENT_BYTES])
{
    moment_format(moment, "%Y-%m-%d %H:%M %Z", text);
}

void moment_stamp(time_t moment, char text[MOMENT_BYTES])
{
    moment_format(moment, "%Y-%m-%d %H:%M:%S %z", text);
}
