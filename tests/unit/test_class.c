// Unit tests of a class's names and groups: who handed in what, and who failed alike.
#include "csv_cell.h"
#include "entry_name.h"
#include "failures.h"
#include "sha256.h"
#include <string.h>

#include <criterion/criterion.h>

Test(entry_name, knows_what_systems_add)
{
    static const struct {
        const char *entry, *name, *number;
    } cases[] = {
        {"ada", "ada", ""},
        {"Ada Lovelace.zip", "Ada Lovelace", ""},
        {"ada.tar.gz", "ada", ""},
        {"ada.TGZ", "ada", ""},
        {".zip", ".zip", ""},
        {"Ada Lovelace_1234567_assignsubmission_file", "Ada Lovelace", "1234567"},
        {"Ada Lovelace_1234567_assignsubmission_file_/", "Ada Lovelace", "1234567"},
        {"A_B_77_assignsubmission_file_lab.zip", "A_B", "77"},
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

Test(entry_name, finds_the_number_of_an_attempt)
{
    static const struct {
        const char *name;
        int attempt, stem;
    } cases[] = {
        {"ada", 1, 3},     {"ada-2", 2, 3},           {"ada_3", 3, 3},
        {"ada (2)", 2, 3}, {"ada-2026", 1, 8},        {"ada2", 1, 4},
        {"-2", 1, 2},      {"ada(2)", 1, 6},          {"a-12", 12, 1},
        {"ada 2)", 1, 6},  {"submission_99", 99, 10},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        int stem;
        const int attempt = entry_name_attempt(cases[i].name, &stem);
        cr_expect_eq(attempt, cases[i].attempt, "%s: found %d", cases[i].name, attempt);
        cr_expect_eq(stem, cases[i].stem, "%s: found a stem of %d", cases[i].name, stem);
    }
}

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

Test(sha256, is_what_the_standard_says)
{
    static const struct {
        int n;  // letters a
        unsigned char end[4];
    } cases[] = {
        {0, {0x78, 0x52, 0xb8, 0x55}},   {1, {0xaf, 0xee, 0x48, 0xbb}},
        {55, {0x0f, 0x73, 0x43, 0x18}},  {56, {0x6e, 0xc6, 0x73, 0x8a}},
        {63, {0x7d, 0xdc, 0x2f, 0x34}},  {64, {0x15, 0x46, 0x68, 0xeb}},
        {65, {0x17, 0xeb, 0x0a, 0xe0}},  {119, {0x65, 0x84, 0xdc, 0xfb}},
        {120, {0xf9, 0x04, 0xc2, 0x1c}}, {200, {0xe7, 0xc2, 0x8a, 0xe5}},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char text[200];
        unsigned char digest[SHA256_BYTES];
        memset(text, 'a', sizeof text);
        sha256(text, (size_t)cases[i].n, digest);
        cr_expect_arr_eq(digest + SHA256_BYTES - 4, cases[i].end, 4, "%d letters", cases[i].n);
    }
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

static Row row_make(const char *check, const char *message)
{
    return (Row){
        .fault = (char *)"A title", .fault_id = (char *)check, .fault_message = (char *)message};
}

Test(failures, are_the_same_whatever_the_numbers)
{
    Row rows[] = {
        row_make("one", "pixel (3, 4): found 0.5, expected -1e-05; it looks flipped"),
        row_make("two", "pixel (3, 4): found 0.5, expected 1"),
        {0},
        row_make("one", "pixel (317, 44): found 12, expected 0.25; it looks flipped"),
        row_make("one", "pixel (317, 44): found 12, expected 0.25; it looks strict"),
    };
    const Gradebook gradebook = {.rows = rows, .n_rows = 5};
    Failures failures;
    cr_assert_eq(failures_find(&gradebook, &failures), 0);
    cr_assert_eq(failures.n_failures, 3);
    cr_expect_eq(failures.failures[0].n_rows, 2);
    cr_expect_eq(failures.failures[0].rows[0], &rows[0]);
    cr_expect_eq(failures.failures[0].rows[1], &rows[3]);
    // Of groups of one size, the one whose first row comes first.
    cr_expect_eq(failures.failures[1].first, &rows[1]);
    cr_expect_eq(failures.failures[2].first, &rows[4]);
    failures_free(&failures);
}
