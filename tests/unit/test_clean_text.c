// common/clean_text: whatever a student's code put into a message, a terminal and a page can show
// it.
#include "clean_text.h"
#include "line_reader.h"
#include "message.h"
#include "report_texts.h"

Test(clean_text, keeps_what_can_be_shown_and_replaces_the_rest)
{
    static const char *const pairs[][2] = {
        {"plain text", "plain text"},
        {"distance\xC2\xB2 <= radius\xC2\xB2", "distance\xC2\xB2 <= radius\xC2\xB2"},
        {"\xF0\x9F\x98\x80", "\xF0\x9F\x98\x80"},
        {"two\n\tlines\n\n", "two\n\tlines"},
        {"two\r\nlines", "two\nlines"},
        {"back\r", "back\\x0D"},
        {"\033[2Jgone", "\\x1B[2Jgone"},
        {"\x7F\x08\x07", "\\x7F\\x08\\x07"},
        {"\xC2\x9B"
         "2J",
         "\\xC2\\x9B2J"},  // C1 control sequence introducer
        {"a\xE2\x80\xAE"
         "b",
         "a\\xE2\\x80\\xAEb"},  // right-to-left override
        {"\xE2\x80\x8B\xEF\xBB\xBF\xF3\xA0\x81\x81",
         "\\xE2\\x80\\x8B\\xEF\\xBB\\xBF\\xF3\\xA0\\x81\\x81"},    // not seen
        {"\xC2\xAC\xF3\xA0\x82\x80", "\xC2\xAC\xF3\xA0\x82\x80"},  // beside them
        {"\xFF\xFE", "\\xFF\\xFE"},
        {"\xC3", "\\xC3"},                             // broken off
        {"\xC0\xAF", "\\xC0\\xAF"},                    // longer than needed
        {"\xED\xA0\x80", "\\xED\\xA0\\x80"},           // half of a surrogate pair
        {"\xF4\x90\x80\x80", "\\xF4\\x90\\x80\\x80"},  // beyond U+10FFFF
        {"", ""},
        {NULL, ""},
    };
    for (size_t i = 0; i < sizeof pairs / sizeof pairs[0]; i++) {
        char *clean = message_clean(pairs[i][0]);
        cr_expect_str_eq(clean, pairs[i][1], "pair %zu: found \"%s\"", i, clean);
        free(clean);
    }
    char *line = line_clean("a\tb\nc");
    cr_expect_str_eq(line, "a b c");
    free(line);
}

// message_show(): what a student called a file.
Test(clean_text, a_name_keeps_its_letters)
{
    char shown[16];
    cr_expect_str_eq(message_show("L\xC3\xB6sung \xC3\x9C.pdf", shown, sizeof shown),
                     "L\xC3\xB6sung \xC3\x9C.pdf");
    cr_expect_str_eq(message_show("a\xFF\nb", shown, sizeof shown), "a\\xFF\\x0Ab");
    // Cut between characters, on both sides.
    cr_expect_str_eq(
        message_show("\xE2\x82\xAC\xE2\x82\xAC\xE2\x82\xAC\xE2\x82\xAC\xE2\x82\xAC\xE2\x82\xAC",
                     shown, sizeof shown),
        "\xE2\x82\xAC\xE2\x82\xAC...\xE2\x82\xAC\xE2\x82\xAC");
}

// line_quote(): what a file holds, cut between characters.
Test(clean_text, a_quotation_keeps_its_letters)
{
    char quoted[LINE_QUOTE_SIZE], found[64] = "", expected[64] = "";
    cr_expect_str_eq(line_quote("H\xC3\xB6he", quoted), "\"H\xC3\xB6he\"");
    for (int i = 0; i < 14; i++) {
        strcat(found, "\xE2\x82\xAC");
    }
    snprintf(expected, sizeof expected, "\"%.39s...\"", found);
    cr_expect_str_eq(line_quote(found, quoted), expected);
    memset(found, '\xFF', LINE_QUOTE_BYTES + 1);
    found[LINE_QUOTE_BYTES + 1] = '\0';
    cr_expect_eq(strlen(line_quote(found, quoted)), 4 * LINE_QUOTE_BYTES + 5);
}

Test(clean_text, shortens_a_long_message_in_the_middle)
{
    char *text = repeated("\xE2\x82\xAC", 40000);
    text[0] = 'A', text[1] = 'B', text[2] = 'C';
    char *clean = message_clean(text);
    cr_expect_leq(strlen(clean), (size_t)MESSAGE_MAX_BYTES);
    cr_expect_eq(strncmp(clean, "ABC\xE2\x82\xAC", 6), 0);
    expect_part(clean, " bytes left out ...] \xE2\x82\xAC");
    // Cut between characters: cleaning again changes nothing.
    char *again = message_clean(clean);
    cr_expect_str_eq(again, clean);
    free(again);
    free(clean);
    clean = line_clean(text);
    cr_expect_leq(strlen(clean), (size_t)LINE_MAX_BYTES + 64);
    free(clean);
    free(text);
}

Test(clean_text, shortens_many_lines_to_forty)
{
    for (int n_lines = 38; n_lines <= 300; n_lines += n_lines < 45 ? 1 : 51) {
        char text[8192] = "";
        for (int i = 1; i <= n_lines; i++) {
            sprintf(text + strlen(text), "line %d\n", i);
        }
        char *clean = message_clean(text);
        char last[32];
        snprintf(last, sizeof last, "\nline %d", n_lines);
        int n_kept = 1;
        for (const char *at = clean; (at = strchr(at, '\n')) != NULL; at++) {
            n_kept++;
        }
        cr_expect_eq(n_kept, n_lines < 40 ? n_lines : 40);
        cr_expect_str_eq(clean + strlen(clean) - strlen(last), last);
        expect_part(clean, "line 29\n");
        if (n_lines == 299) {
            expect_part(clean, "line 29\n[... 260 lines left out ...]\nline 290\n");
        }
        free(clean);
    }
}
