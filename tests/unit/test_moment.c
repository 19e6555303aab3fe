// class/texts/moment: times as course systems and people write them.
#include "moment.h"
#include "surroundings.h"

// 25 November 2026, 22:05 in Greenwich, by `date -u -d '2026-11-25 22:05' +%s`.
static const time_t evening = 1795644300;

static void expect_moment(const char *text, time_t expected)
{
    time_t moment = 0;
    const int result = moment_read(text, &moment);
    cr_expect(result == 0 && moment == expected, "\"%s\": %d, %lld, expected %lld", text, result,
              (long long)moment, (long long)expected);
}

Test(moment, local_times_are_of_the_zone_that_was_set)
{
    cr_assert_eq(moment_zone_set("Europe/Berlin"), 0);
    const char *const texts[] = {
        "2026-11-25 23:05",
        "2026-11-25 23:05:00",
        "2026-11-25T23:05",
        "2026-11-25-23-05-00",
        "2026-11-25-23-05",
        "20261125230500",
        "25.11.2026 23:05",
        "25.11.2026, 23:05",
        "Wednesday, 25 November 2026, 11:05 PM",
        "Wednesday, 25 November 2026, 11:05\u202fPM",
        "Wednesday, November 25, 2026, 11:05 PM",
        "Mittwoch, 25. November 2026, 23:05",
        "25 Nov 2026, 23:05",
        "  Wednesday,\u00a025 November 2026, 11:05 pm ",
    };
    for (size_t i = 0; i < sizeof texts / sizeof *texts; i++) {
        expect_moment(texts[i], evening);
    }
}

Test(moment, a_zone_of_its_own_counts_before_that)
{
    cr_assert_eq(moment_zone_set("Asia/Kolkata"), 0);
    expect_moment("2026-11-25T23:05:00+01:00", evening);
    expect_moment("2026-11-25 14:05:00 -0800", evening);
    expect_moment("2026-11-25 22:05:00.711434000 Z", evening);
    expect_moment("2026-11-25 22:05:00 UTC", evening);
    expect_moment("2026-11-26 03:35", evening);
}

Test(moment, summer_and_winter)
{
    cr_assert_eq(moment_zone_set("Europe/Berlin"), 0);
    expect_moment("Freitag, 26. Juni 2026, 23:05", 1782507900);
    expect_moment("26 June 2026 11:05 PM", 1782507900);
    expect_moment("2026-06-26T21:05Z", 1782507900);
    char text[MOMENT_BYTES];
    moment_write(1782507900, text);
    cr_expect_str_eq(text, "2026-06-26 23:05 CEST");
    cr_assert_eq(moment_zone_set("+05:30"), 0);
    moment_write(evening, text);
    cr_expect_str_eq(text, "2026-11-26 03:35 UTC+0530");
    cr_assert_eq(moment_zone_set("-08:00"), 0);
    expect_moment("2026-11-25 14:05", evening);
}

Test(moment, german_months)
{
    static const char *const months[] = {"Januar",    "Februar", "März",     "April",
                                         "Mai",       "Juni",    "Juli",     "August",
                                         "September", "Oktober", "November", "Dezember"};
    cr_assert_eq(moment_zone_set("UTC"), 0);
    for (int i = 0; i < 12; i++) {
        char german[64], numbers[64];
        time_t expected;
        snprintf(german, sizeof german, "Montag, 2. %s 2026, 08:30", months[i]);
        snprintf(numbers, sizeof numbers, "2026-%02d-02 08:30", i + 1);
        cr_assert_eq(moment_read(numbers, &expected), 0);
        expect_moment(german, expected);
    }
    expect_moment("2. Maerz 2026, 08:30", 1772440200);
    expect_moment("2. Ma\u0308rz 2026, 08:30", 1772440200);
}

// A time at which clocks are changed, in zones of both halves of the earth, one of half an hour.
typedef struct Change {
    const char *zone, *text;
    time_t expected;  // by `date -u -d ... +%s`
} Change;

static const Change changes[] = {
    {"Europe/Berlin", "2026-10-25 01:59", 1792886340},        // 23:59 in Greenwich
    {"Europe/Berlin", "2026-10-25 02:30", 1792888200},        // shown twice: 00:30
    {"Europe/Berlin", "2026-10-25 03:00", 1792893600},        // 02:00
    {"Europe/Berlin", "2026-03-29 01:59", 1774745940},        // 00:59
    {"Europe/Berlin", "2026-03-29 02:30", 1774744200},        // never shown: 00:30
    {"Europe/Berlin", "2026-03-29 03:00", 1774746000},        // 01:00
    {"America/New_York", "2026-11-01 01:30", 1793511000},     // twice: 05:30
    {"America/New_York", "2026-11-01 02:00", 1793516400},     // 07:00
    {"America/New_York", "2026-03-08 02:30", 1772951400},     // never: 06:30
    {"America/New_York", "2026-03-08 03:00", 1772953200},     // 07:00
    {"Australia/Lord_Howe", "2026-04-05 01:45", 1775313900},  // twice: 14:45 of the day before
    {"Australia/Lord_Howe", "2026-04-05 02:00", 1775316600},  // 15:30
    {"Australia/Lord_Howe", "2026-10-04 02:15", 1791040500},  // never: 15:15
    {"Australia/Lord_Howe", "2026-10-04 02:30", 1791041400},  // 15:30
    {"UTC", "2026-10-25 02:30", 1792895400},
};

// In both orders: mktime() answers by what it was asked before.
Test(moment, where_clocks_change_the_first_moment_counts)
{
    const int n = (int)(sizeof changes / sizeof *changes);
    for (int i = 0; i < 2 * n; i++) {
        const Change *change = &changes[i < n ? i : 2 * n - 1 - i];
        cr_assert_eq(moment_zone_set(change->zone), 0);
        expect_moment(change->text, change->expected);
    }
    cr_assert_eq(moment_zone_set("Europe/Berlin"), 0);
    expect_moment("2026-10-25 02:30 +0100", 1792888200 + 3600);
}

Test(moment, hours_are_real_and_days_are_the_calendars)
{
    enum { HOUR = 60 * 60, DAY = 24 * HOUR };
    static const struct {
        const char *from, *to;
        long n, unit;
    } cases[] = {
        {"2026-10-24 20:00", "2026-10-25 20:00", 1, DAY},  // 25 hours
        {"2026-10-24 20:00", "2026-10-25 19:00", 24, HOUR},
        {"2026-10-24 20:00", "2026-10-25 20:00", 25, HOUR},
        {"2026-10-24 02:30", "2026-10-25 02:30", 1, DAY},  // to the first of the two
        {"2026-03-28 20:00", "2026-03-29 20:00", 1, DAY},  // 23 hours
        {"2026-03-28 20:00", "2026-03-29 21:00", 24, HOUR},
        {"2026-03-25 20:00", "2026-04-01 20:00", 1, 7 * DAY},
    };
    cr_assert_eq(moment_zone_set("Europe/Berlin"), 0);
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        time_t from, to;
        cr_assert_eq(moment_read(cases[i].from, &from), 0);
        cr_assert_eq(moment_read(cases[i].to, &to), 0);
        cr_expect_eq(moment_later(from, cases[i].n, cases[i].unit), to,
                     "%ld units of %ld s from %s", cases[i].n, cases[i].unit, cases[i].from);
    }
}

Test(moment, what_is_none_is_refused)
{
    static const char *const texts[] = {
        "",
        "-",
        "yesterday",
        "2026-11-25",
        "11/25/2026 23:05",
        "2026-02-30 10:00",
        "2026-13-01 10:00",
        "2026-11-25 24:30",
        "2026-11-25 23:05 tomorrow",
        "2026-11-25 23:05 CET",
        "Wednesday, 25 Novembre 2026, 23:05",
        "Wednesday, 25 November 2026, 13:05 PM",
        "25 November 2026 23:05 25 November 2026 23:05 25 November 2026 23:05 and so on and on",
    };
    time_t moment;
    cr_assert_eq(moment_zone_set("UTC"), 0);
    for (size_t i = 0; i < sizeof texts / sizeof *texts; i++) {
        cr_expect_eq(moment_read(texts[i], &moment), -1, "\"%s\"", texts[i]);
    }
}

Test(moment, zones_that_are_none)
{
    static const char *const zones[] = {"CET",
                                        "Berlin",
                                        "Europe/Nowhere",
                                        "../../etc/passwd",
                                        "/etc/passwd",
                                        "+25:00",
                                        "+1",
                                        "",
                                        "Europe/../../../etc/passwd"};
    for (size_t i = 0; i < sizeof zones / sizeof *zones; i++) {
        cr_expect_eq(moment_zone_set(zones[i]), -1, "\"%s\"", zones[i]);
    }
    cr_expect_eq(moment_zone_set(NULL), 0);
}
