// class/texts/sheet_number and sheet_text: lists as course systems and spreadsheets write them.
#include "sheet.h"
#include "surroundings.h"

#include <stdlib.h>
#include <string.h>

Test(sheet_number, as_people_write_them)
{
    static const struct {
        const char *text;
        double number;
        char decimal;
    } rows[] = {
        {"100", 100, '.'},
        {"100.00", 100, '.'},
        {"99,50", 99.5, ','},
        {"1,000.00", 1000, '.'},
        {"1.000,00", 1000, ','},
        {"1 000,00", 1000, ','},
        {"1\xC2\xA0"
         "000,00",
         1000, ','},
        {"1\xE2\x80\xAF"
         "000",
         1000, '.'},
        {"1'000.5", 1000.5, '.'},
        {"1,234,567", 1234567, '.'},
        {"1000.125", 1000.125, '.'},
        {"0,125", 0.125, ','},
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        double number = -1;
        char decimal = '?';
        cr_expect_eq(sheet_number_read(rows[i].text, &number, &decimal), 0, "%s", rows[i].text);
        cr_expect_eq(number, rows[i].number, "%s: %g", rows[i].text, number);
        cr_expect_eq(decimal, rows[i].decimal, "%s: %c", rows[i].text, decimal);
    }
}

// "1,000" is a thousand to one reader and one to another.
Test(sheet_number, what_is_no_number_or_two)
{
    static const char *const texts[] = {
        "",       "-",     "abc",     "100 points", "100%",     "-5",      "1,000", "1.000",
        "1,00,0", "10 00", "1.000.0", "1,",         ",5",       "1e3",     "1 0",   "12 34,5",
        "0x10",   "nan",   "1 000 ",  "1.000,0,0",  "1'00.000", "1,0000.5"};
    for (size_t i = 0; i < sizeof texts / sizeof *texts; i++) {
        double number;
        char decimal;
        cr_expect_neq(sheet_number_read(texts[i], &number, &decimal), 0, "%s", texts[i]);
    }
}

static const char *find(const char *bytes, SheetText *sheet)
{
    return sheet_text_find(bytes, strlen(bytes), sheet);
}

Test(sheet_text, signs_between_cells)
{
    static const struct {
        const char *bytes, *rest;
        char delimiter;
    } rows[] = {
        {"Name,Grade\nA,1\n", "Name", ','},
        {"\xEF\xBB\xBFName;Grade\nA;1,5\n", "Name", ';'},
        {"Name\tGrade\nA\t1,5\n", "Name", '\t'},
        {"sep=;\r\nName,first;Grade\nA;1\n", "Name", ';'},
        {"\xEF\xBB\xBFsep=\t\nName\tGrade\n", "Name", '\t'},
        {"Name\nA\n", "Name", ','},
        {"\"a,b,c\"\t\"d,e\"\n", "\"a", '\t'},
        {"Name;Lab 3, part 1;Lab 4\n", "Name", ';'},
        {"Name,\"a;b;c;d\"\n", "Name", ','},
        {"sep=", "sep=", ','},
        {"", "", ','},
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        SheetText sheet;
        cr_expect_null(find(rows[i].bytes, &sheet), "%s", rows[i].bytes);
        cr_expect_eq(sheet.form.delimiter, rows[i].delimiter, "%s", rows[i].bytes);
        cr_expect_eq(strncmp(sheet.text, rows[i].rest, strlen(rows[i].rest)), 0, "%s",
                     rows[i].bytes);
        cr_expect_eq(sheet.text + sheet.length, rows[i].bytes + strlen(rows[i].bytes));
    }
}

Test(sheet_text, what_is_no_table_is_named)
{
    static const struct {
        const char *bytes, *said;
    } rows[] = {
        {"\xFF\xFEN", "UTF-16"},
        {"\xFE\xFF", "UTF-16"},
        {"PK\3\4", "workbook"},
        {"\xD0\xCF\x11\xE0", "workbook"},
        {"\r\n <!DOCTYPE html><html>", "login"},
        {"<HTML lang=\"de\">", "login"},
        {"Name,Grade\nJ\xFCrgen,1\n", "no UTF-8"},
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        SheetText sheet;
        const char *said = find(rows[i].bytes, &sheet);
        cr_assert_not_null(said, "%s", rows[i].bytes);
        cr_expect_not_null(strstr(said, rows[i].said), "%s", said);
    }
}

Test(sheet_text, utf16_becomes_utf8)
{
    static const char *const right[] = {"\xFF\xFE"
                                        "A\0\xFC\0\x3D\xD8\x0A\xDE",
                                        "\xFE\xFF"
                                        "\0A\0\xFC\xD8\x3D\xDE\x0A"};
    for (int i = 0; i < 2; i++) {
        size_t n = 0;
        char *utf8 = sheet_text_from_utf16(right[i], 10, &n);
        cr_assert_not_null(utf8);
        cr_expect_eq(n, 7);
        cr_expect_eq(memcmp(utf8, "A\xC3\xBC\xF0\x9F\x98\x8A", 7), 0);
        free(utf8);
        // Half a character, then half a unit.
        cr_expect_null(sheet_text_from_utf16(right[i], 8, &n));
        cr_expect_null(sheet_text_from_utf16(right[i], 9, &n));
    }
    size_t n = 1;
    char *empty = sheet_text_from_utf16("\xFF\xFE", 2, &n);
    cr_expect(empty != NULL && n == 0);
    free(empty);
    cr_expect_null(sheet_text_from_utf16("Name", 4, &n));
    cr_expect_null(sheet_text_from_utf16("", 0, &n));
}

Test(sheet_text, a_byte_that_is_no_character_is_no_text)
{
    SheetText sheet;
    cr_expect_not_null(sheet_text_find("Name\0Grade\n", 11, &sheet));
}
