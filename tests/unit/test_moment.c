// class/moment: times as course systems and people write them.
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
