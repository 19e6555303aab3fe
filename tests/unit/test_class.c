// Unit tests of a class's names and groups: who handed in what, who failed alike, who is fastest.
#include "csv_cell.h"
#include "entry_name.h"
#include "failures.h"
#include "leaderboard.h"
#include "look_alikes.h"
#include "name_likeness.h"
#include "option_table.h"
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#include <criterion/criterion.h>
#include <unicode/utf8.h>

Test(entry_name, knows_what_systems_add)
{
    static const struct {
        const char *entry, *name, *number;
    } cases[] = {
        {"ada", "ada", ""},
        {"Ada Lovelace.zip", "Ada Lovelace", ""},
        {"ada.tar.gz", "ada", ""},
        {"ada.TGZ", "ada", ""},
        {"ada.tbz2", "ada", ""},
        {"ada.tar.zst", "ada", ""},
        {"ada.tzst", "ada", ""},
        {"ada.zst", "ada", ""},
        {".zip", ".zip", ""},
        {"Ada Lovelace_1234567_assignsubmission_file", "Ada Lovelace", "1234567"},
        {"Ada Lovelace_1234567_assignsubmission_file_/", "Ada Lovelace", "1234567"},
        {"A_B_77_assignsubmission_file_lab.zip", "A_B", "77"},
        {"Ada_22_assignsubmission_file__99_assignsubmission_file_",
         "Ada_22_assignsubmission_file__99_assignsubmission_file_", ""},
        {"_1_assignsubmission_file_", "_1_assignsubmission_file_", ""},
        {"Default group_assignsubmission_file_", "Default group", ""},
        {"submission_123456", "submission_123456", "123456"},
        {"submission_12x", "submission_12x", ""},
        {"lab-03-ada", "ada", ""},
        {"Lab_3_ada-l", "ada-l", ""},
        {"lab03-ada.zip", "ada", ""},
        {"lab-04-ada", "lab-04-ada", ""},
        {"lab-03-", "lab-03-", ""},
        {"a\nb", "a\\x0Ab", ""},
        {"a\\x0Ab", "a\\x5Cx0Ab", ""},
        {"M\xC3\xBCller", "M\xC3\xBCller", ""},
        {"M\xFCller", "M\\xFCller", ""},
        {"\xE2\x80\xAE"
         "cod",
         "\\xE2\\x80\\xAE"
         "cod",
         ""},
        {"\xC0\xAF", "\\xC0\\xAF", ""},
        {"\xED\xA0\x80", "\\xED\\xA0\\x80", ""},
        {"cut\xE2\x82", "cut\\xE2\\x82", ""},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        const EntryName name = entry_name_read(cases[i].entry, 3);
        cr_expect_str_eq(name.name, cases[i].name, "%s: found %s", cases[i].entry, name.name);
        cr_expect_str_eq(name.number, cases[i].number, "%s: found %s", cases[i].entry, name.number);
    }
}

Test(entry_name, holds_the_longest_name)
{
    char entry[256];
    memset(entry, '\xFF', 255);
    entry[255] = '\0';
    const EntryName name = entry_name_read(entry, 0);
    cr_expect_eq(strlen(name.name), 4u * 255);
}

// ---- Likeness ----------------------------------------------------------------------------------

Test(name_likeness, sees_one_person_in_two_names)
{
    static const struct {
        const char *name, *other;
        int alike;
    } cases[] = {
        {"ada-2", "ada", 1},
        {"ada_3", "ada", 1},
        {"ada (2)", "ada", 1},
        {"ada(2)", "ada", 1},
        {"ada 2 ", "ada", 1},
        {"Ada", "ada", 1},
        {"ada .", "ada", 1},
        {"Ada_Lovelace", "ada lovelace", 1},
        {"M\xC3\xBCller", "Mu\xCC\x88ller", 1},  // composed, decomposed
        {"\xD0\xB0\xD0\xB4\xD0\xB0", "\xD0\xB0\xD0\xB4\xD0\xB0", 1},
        {"\xD0\xB0"
         "da",
         "ada", 1},  // a Cyrillic letter
        {"\xEF\xBD\x81"
         "da",
         "ada", 1},                        // a full-width one
        {"ad\\xE2\\x80\\x8Ba", "ada", 1},  // a blank without width
        {"ad\u0251", "ada", 1},            // Latin alpha
        {"\u1D00da", "ada", 1},            // a small capital
        {"\uAB31da", "ada", 1},            // reversed schwa
        {"\U0001F150da", "ada", 1},        // in a black circle
        {"\u0391\u0414\u0391", "\u0430\u0434\u0430",
         1},                            // Greek capitals, a Cyrillic D; Cyrillic small
        {"\u2800ada\u3164", "ada", 1},  // of Braille and Hangul what shows nothing
        {"\u0141\u00F3d\u017A", "lodz", 1},
        {"\u0928\u093E", "\u0928\u0940", 0},  // another vowel is another name
        {"adarn", "adam", 1},
        {"car0l", "carol", 1},
        {"Carol", "caroI", 1},  // a capital i
        {"\xE6\x9D\x8E", "\xE6\x9D\x8E", 1},
        {"\xE6\x9D\x8E", "\xE7\x8E\x8B", 0},
        {"ada-2026", "ada", 0},  // a year is no attempt
        {"ada2", "ada", 0},
        {"ada-2", "ada-3", 0},
        {"-2", "", 0},
        {"..", "...", 0},
        {"ada", "ada-2", 0},
        {"bob", "ada", 0},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        cr_expect_eq(name_looks_like(cases[i].name, cases[i].other), cases[i].alike,
                     "\"%s\" and \"%s\": expected %d", cases[i].name, cases[i].other,
                     cases[i].alike);
    }
}

// Of each that Unicode has: ICU may know more of them tomorrow, and none may be too long.
Test(name_likeness, takes_every_character)
{
    for (UChar32 code = 1; code < 0x110000; code++) {
        char name[8] = "", key[ENTRY_NAME_BYTES];
        int n = 0;
        U8_APPEND_UNSAFE(name, n, code);
        name_likeness(name, key);
        cr_expect_lt(strlen(key), 100, "U+%04X", (unsigned)code);
    }
}

Test(look_alikes, are_listed_unless_the_host_tells_them_apart)
{
    static const struct {
        const char *name;
        int is_exact;
    } names[] = {{"ada", 0},    {"ada-2", 0},  {"ada-3 (2)", 0}, {"Bob", 1},   {"bob", 1},
                 {"team-1", 0}, {"team-2", 0}, {"Carol", 1},     {"carol", 0}, {"..", 0}};
    enum { N_NAMES = sizeof names / sizeof *names };
    Entrant entrants[N_NAMES] = {0};
    Row rows[N_NAMES] = {0};
    for (int i = 0; i < N_NAMES; i++) {
        entrants[i].name = (char *)names[i].name;
        entrants[i].is_exact = names[i].is_exact;
        rows[i].entrant = &entrants[i];
    }
    const Gradebook gradebook = {.rows = rows, .n_rows = N_NAMES};
    LookAlikes found;
    cr_assert_eq(look_alikes_find(&gradebook, &found), 0);
    cr_assert_eq(found.n_groups, 2, "found %d groups", found.n_groups);
    cr_expect_eq(found.groups[0].n_rows, 3, "found %d rows", found.groups[0].n_rows);
    cr_expect_eq(found.groups[0].rows[2], &rows[2]);
    cr_expect_eq(found.groups[1].n_rows, 2);
    cr_expect_eq(found.groups[1].rows[0], &rows[7]);
    look_alikes_free(&found);
}

// ---- Slugs -------------------------------------------------------------------------------------

Test(entry_name, makes_slugs_that_are_safe_and_different)
{
    static const char *const entries[] = {"Ada", "ada", "..", "-rf", "a/b", "\xFF", "a b", "a\nb"};
    char slugs[8][ENTRY_SLUG_BYTES];
    for (int i = 0; i < 8; i++) {
        entry_name_slug(entries[i], entries[i], slugs[i]);
        cr_expect_eq(strspn(slugs[i], "abcdefghijklmnopqrstuvwxyz0123456789-"), strlen(slugs[i]));
        cr_expect_neq(slugs[i][0], '-');
        for (int j = 0; j < i; j++) {
            cr_expect_str_neq(slugs[i], slugs[j]);
        }
    }
}

Test(entry_name, makes_slugs_that_end_differently)
{
    // Two names that a 32-bit hash made equal, found in a second.
    static const char *const entries[] = {"ada-76651", "ada-117211"};
    char slugs[2][ENTRY_SLUG_BYTES];
    for (int i = 0; i < 2; i++) {
        entry_name_slug("ada", entries[i], slugs[i]);
    }
    cr_expect_str_neq(slugs[0], slugs[1]);
    entry_name_slug("Ada L.", "abc", slugs[0]);
    cr_expect_str_eq(slugs[0], "ada-l-ba7816bf8f01cfea", "found %s", slugs[0]);
}

// ---- Cells -------------------------------------------------------------------------------------

Test(csv_cell, is_no_formula_wherever_cells_are_parted)
{
    static const struct {
        const char *text, *cell;
    } cases[] = {
        {"ada", "\"ada\""},
        {"", "\"\""},
        {"a \"b\"", "\"a \"\"b\"\"\""},
        {"=1+1", "\"'=1+1\""},
        {"@A1", "\"'@A1\""},
        {"＝1＋1", "\"'＝1＋1\""},
        {"＋1", "\"'＋1\""},
        {"－1", "\"'－1\""},
        {"＠A1", "\"'＠A1\""},
        {"﹦1", "\"'﹦1\""},
        {"−1", "\"'−1\""},
        {"x;=1+1;b", "\"x;'=1+1;b\""},
        {"x\t-1", "\"x\t'-1\""},
        {"x|@A1", "\"x|'@A1\""},
        {"x,＝1", "\"x,'＝1\""},
        {"x\n=1", "\"x\n'=1\""},
        {";;=1", "\";;'=1\""},
        {" =1", "\" '=1\""},
        {"\xE3\x80\x80=1", "\"\xE3\x80\x80'=1\""},
        {"\xE2\x80\x83=1", "\"\xE2\x80\x83'=1\""},
        {"\u1680=1", "\"\u1680'=1\""},
        {"\u205F=1", "\"\u205F'=1\""},
        {"\u3164=1", "\"\u3164'=1\""},
        {"\u2800=1", "\"\u2800'=1\""},
        {"\u00AD=1", "\"\u00AD'=1\""},
        {"\u200F\u202E=1", "\"\u200F\u202E'=1\""},
        {"\uFEFF \u0300\u2800=1", "\"\uFEFF \u0300\u2800'=1\""},
        {"x\u2028=1", "\"x\u2028'=1\""},
        {"x;\"=1\"", "\"x;\"\"'=1\"\"\""},
        {"Anna-Lena", "\"Anna-Lena\""},
        {"a = b; c", "\"a = b; c\""},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char found[64] = "";
        FILE *file = fmemopen(found, sizeof found, "w");
        csv_cell_write(file, cases[i].text);
        fclose(file);
        cr_expect_str_eq(found, cases[i].cell, "%s: found %s", cases[i].text, found);
    }
}

// Whatever Unicode has of blanks, marks and characters without a picture.
Test(csv_cell, is_no_formula_behind_anything_unseen)
{
    static const struct {
        UChar32 first, last;
    } ranges[] = {{0x01, 0x09},     {0x0B, 0x0C},       {0x0E, 0x20},      {0x7F, 0xA0},
                  {0xAD, 0xAD},     {0x300, 0x36F},     {0x61C, 0x61C},    {0x115F, 0x1160},
                  {0x1680, 0x1680}, {0x17B4, 0x17B5},   {0x180B, 0x180F},  {0x2000, 0x200F},
                  {0x2028, 0x202F}, {0x205F, 0x206F},   {0x2800, 0x2800},  {0x3000, 0x3000},
                  {0x3164, 0x3164}, {0xFE00, 0xFE0F},   {0xFEFF, 0xFEFF},  {0xFFA0, 0xFFA0},
                  {0xFFF0, 0xFFFB}, {0x1D173, 0x1D17A}, {0xE0000, 0xE0FFF}};
    for (size_t i = 0; i < sizeof ranges / sizeof *ranges; i++) {
        for (UChar32 code = ranges[i].first; code <= ranges[i].last; code++) {
            char text[16], found[32] = "";
            int n = 0;
            U8_APPEND_UNSAFE(text, n, code);
            snprintf(text + n, sizeof text - (size_t)n, "=1");
            FILE *file = fmemopen(found, sizeof found, "w");
            csv_cell_write(file, text);
            fclose(file);
            cr_expect(strstr(found, "'=1") != NULL, "U+%04X: found %s", (unsigned)code, found);
        }
    }
}

Test(csv_cell, leaves_numbers_of_a_list_as_they_are)
{
    static const struct {
        const char *text, *cell;
    } cases[] = {{"-", "\"-\""},        {"-3,50", "\"-3,50\""}, {"+4.0", "\"+4.0\""},
                 {"-1+1", "\"'-1+1\""}, {"=2", "\"'=2\""},      {"-2;=3", "\"'-2;'=3\""}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char found[64] = "";
        FILE *file = fmemopen(found, sizeof found, "w");
        csv_cell_copy(file, cases[i].text);
        fclose(file);
        cr_expect_str_eq(found, cases[i].cell, "%s: found %s", cases[i].text, found);
    }
}

// ---- Failures --------------------------------------------------------------------------------

static const Entrant ada = {.name = (char *)"ada", .number = (char *)"", .attempt = 1};
static const Entrant bob = {.name = (char *)"bob", .number = (char *)"", .attempt = 1};

// A row of a lab with two checks, which found these.
static Row row_make(const Entrant *entrant, const char *first, const char *second)
{
    return (Row){.entrant = entrant, .found = {(char *)first, (char *)second}};
}

static Gradebook two_checks(Row *rows, int n_rows)
{
    static const Column checks[] = {{.id = "one", .title = "One"}, {.id = "two", .title = "Two"}};
    return (Gradebook){.rows = rows, .n_rows = n_rows, .checks = checks, .n_checks = 2};
}

Test(failures, are_the_same_whatever_the_numbers)
{
    Row rows[] = {
        row_make(&ada, "pixel (3, 4): found 0.5, expected -1e-05; it looks flipped", "also"),
        row_make(&bob, NULL, "pixel (3, 4): found 0.5, expected 1"),
        row_make(&ada, NULL, NULL),
        row_make(&bob, "pixel (317, 44): found 12, expected 0.25; it looks flipped", NULL),
        row_make(&ada, "pixel (317, 44): found 12, expected 0.25; it looks strict", NULL),
    };
    const Gradebook gradebook = two_checks(rows, 5);
    Failures failures;
    cr_assert_eq(failures_find(&gradebook, &failures), 0);
    cr_assert_eq(failures.n_failures, 4);
    cr_expect_eq(failures.failures[0].n_rows, 2);
    cr_expect_eq(failures.failures[0].rows[0], &rows[0]);
    cr_expect_eq(failures.failures[0].rows[1], &rows[3]);
    // Of groups of one size, the one whose first row comes first.
    cr_expect_str_eq(failures.failures[1].sentence, "also");
    cr_expect_eq(failures.failures[2].rows[0], &rows[1]);
    cr_expect_eq(failures.failures[3].rows[0], &rows[4]);
    failures_free(&failures);
}

Test(failures, a_known_cause_is_one_whatever_was_said)
{
    Row rows[] = {row_make(&ada, "a circle is missing", NULL),
                  row_make(&bob, "a row is missing", "x"),
                  row_make(&ada, "a row is missing", NULL)};
    rows[0].causes[0] = rows[1].causes[0] = (char *)"the last one is left out";
    rows[0].picture = rows[1].picture = "picture.png";
    const Gradebook gradebook = two_checks(rows, 3);
    Failures failures;
    cr_assert_eq(failures_find(&gradebook, &failures), 0);
    cr_assert_eq(failures.n_failures, 3);
    cr_expect_eq(failures.failures[0].n_rows, 2);
    cr_expect_str_eq(failures.failures[0].cause, "the last one is left out");
    cr_expect_eq(failures.failures[0].shown, &rows[0], "the other has two faults");
    cr_expect_eq(failures.failures[2].shown, NULL);
    failures_free(&failures);
}

Test(failures, an_earlier_attempt_is_nobodys)
{
    Entrant again = ada;
    again.attempt = 2;
    Row rows[] = {row_make(&ada, "first", NULL), row_make(&again, "second", NULL),
                  row_make(&bob, NULL, NULL)};
    rows[2].stage = (char *)"Compiling", rows[2].stage_said = (char *)"error: x";
    const Gradebook gradebook = two_checks(rows, 3);
    Failures failures;
    cr_assert_eq(failures_find(&gradebook, &failures), 0);
    cr_assert_eq(failures.n_failures, 2);
    cr_expect_str_eq(failures.failures[0].sentence, "second");
    cr_expect_eq(failures.failures[1].check, -1);
    cr_expect_str_eq(failures.failures[1].title, "Compiling");
    failures_free(&failures);
}

// ---- Leaderboard -------------------------------------------------------------------------------

Test(leaderboard, who_is_equal_shares_a_rank_in_the_rosters_order)
{
    static const double figures[] = {4.5, 0, 12.3, 4.5, 1000, 0.1, 0, 4.5};
    static const int rows_in_order[] = {4, 2, 0, 3, 7, 5}, ranks[] = {1, 2, 3, 3, 3, 6};
    enum { N_ROWS = sizeof figures / sizeof *figures, N_PLACES = sizeof ranks / sizeof *ranks };
    Row rows[N_ROWS] = {0};
    for (int i = 0; i < N_ROWS; i++) {
        rows[i].leaderboard = figures[i];
    }
    const Gradebook gradebook = {.rows = rows, .n_rows = N_ROWS};
    Leaderboard found;
    cr_assert_eq(leaderboard_find(&gradebook, &found), 0);
    cr_assert_eq(found.n_places, N_PLACES, "found %d", found.n_places);
    for (int i = 0; i < N_PLACES; i++) {
        cr_expect_eq(found.places[i].row, &rows[rows_in_order[i]], "place %d", i);
        cr_expect_eq(found.places[i].rank, ranks[i], "place %d: rank %d", i, found.places[i].rank);
    }
    leaderboard_free(&found);
}

Test(leaderboard, without_figures_there_are_no_places)
{
    Row rows[2] = {0};
    const Gradebook gradebook = {.rows = rows, .n_rows = 2}, nobody = {0};
    Leaderboard found;
    cr_assert_eq(leaderboard_find(&gradebook, &found), 0);
    cr_expect_eq(found.n_places, 0);
    leaderboard_free(&found);
    cr_assert_eq(leaderboard_find(&nobody, &found), 0);
    cr_expect_eq(found.n_places, 0);
    leaderboard_free(&found);
}

// ---- Options -----------------------------------------------------------------------------------

typedef struct Made {
    const char *list;
    int need, excel;
    const char *own;  // not make's
} Made;

static Made made_read(const char *first)
{
    static const OptionRow rows[] = {
        {"list", "FILE", OPTION_TEXT, offsetof(Made, list), 0, 0, 0, ""},
        {"need-of", "N", OPTION_NUMBER, offsetof(Made, need), 1, 9, 0, ""},
        {.name = "excel", .kind = OPTION_FLAG, .place = offsetof(Made, excel)},
        {"own", "TEXT", OPTION_TEXT, offsetof(Made, own), 0, 0, 0, ""},
    };
    const OptionTable table = {"test", rows, 4, .takes_words = 1, .n_from_make = 3};
    char *words[] = {(char *)"test", (char *)first, (char *)"--own=x", (char *)"word", NULL};
    Made made = {0};
    cr_assert_eq(option_table_read(&table, 4, words, &made, NULL), OPTIONS_RUN);
    cr_expect_str_eq(made.own, "x");
    return made;
}

Test(options, are_makes_variables_only_where_make_says_so)
{
    setenv("LIST", "a b.csv", 1), setenv("NEED_OF", "3", 1), setenv("EXCEL", "", 1);
    setenv("OWN", "foreign", 1);
    const Made made = made_read("--make"), plain = made_read("--own=x");
    cr_expect_str_eq(made.list, "a b.csv");
    cr_expect_eq(made.need, 3);
    cr_expect_eq(made.excel, 0, "an empty one is not given");
    cr_expect_null(plain.list);
    cr_expect_eq(plain.need, 0);
}
