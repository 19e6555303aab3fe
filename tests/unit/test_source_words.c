// grader/source_words: what is one word, what hides, and texts that are broken.
#include "source_words.h"
#include "surroundings.h"

TestSuite(source_words);

Test(source_words, kinds_lines_and_directives)
{
    SourceReader reader =
        source_reader("#include <a.h>\nx->y < \"s\\\"t\" # 'c' // d\n  12u\n%:line");
    static const struct {
        SourceKind kind;
        const char *text;
        int line, in_directive;
    } expected[] = {
        {SOURCE_SIGN, "#", 1, 1},     {SOURCE_NAME, "include", 1, 1},
        {SOURCE_HEADER, "a.h", 1, 1}, {SOURCE_NAME, "x", 2, 0},
        {SOURCE_SIGN, "->", 2, 0},    {SOURCE_NAME, "y", 2, 0},
        {SOURCE_SIGN, "<", 2, 0},     {SOURCE_STRING, "s\\\"t", 2, 0},
        {SOURCE_SIGN, "#", 2, 0},     {SOURCE_CHARACTER, "c", 2, 0},
        {SOURCE_NUMBER, "12u", 3, 0}, {SOURCE_SIGN, "#", 4, 1},
        {SOURCE_NAME, "line", 4, 1},  {SOURCE_END, "", 4, 1},
        {SOURCE_END, "", 4, 1},
    };
    for (size_t i = 0; i < sizeof expected / sizeof *expected; i++) {
        const SourceWord word = source_next(&reader);
        cr_expect_eq(word.kind, expected[i].kind, "word %zu \"%s\"", i, word.text);
        cr_expect_str_eq(word.text, expected[i].text);
        cr_expect_eq(word.line, expected[i].line, "word %zu \"%s\"", i, word.text);
        cr_expect_eq(word.in_directive, expected[i].in_directive, "word %zu", i);
    }
}

// The words as they stand in the source, with blanks between them.
static void expect_words(const char *source, const char *expected)
{
    char joined[256] = "";
    int n_words;
    SourceWord *words = source_words(source, &n_words);
    cr_assert_not_null(words);
    for (int i = 0; i < n_words; i++) {
        const size_t length = strlen(joined);
        snprintf(joined + length, sizeof joined - length, "%s%.*s", i > 0 ? " " : "",
                 (int)words[i].length, words[i].start);
    }
    cr_expect_str_eq(joined, expected);
    free(words);
}

Test(source_words, the_longest_sign_is_one_word)
{
    expect_words("a<<=b->c++ + ++d;", "a <<= b -> c ++ + ++ d ;");
}

Test(source_words, numbers_keep_exponent_and_suffix)
{
    expect_words("1e-3f+.5-0x1Fu*0x1p-2-0xE+1", "1e-3f + .5 - 0x1Fu * 0x1p-2 - 0xE + 1");
}

Test(source_words, comments_strings_and_directives_hide_what_is_in_them)
{
    expect_words("a // b + c\n/* d\n < e */ f", "a f");
    expect_words("\"a + \\\"b\" 'c' d", "\"a + \\\"b\" 'c' d");
    expect_words("#define A 1 + \\\n 2\n  # if B\nc", "c");
    expect_words("/* a */ # if B\nc", "c");
    expect_words("a # b", "a # b");
}

Test(source_words, lines_are_joined_and_trigraphs_read)
{
    SourceReader reader = source_reader("a\\\nb c?\?/ \nd ?\?!?\?! ?\?x");
    static const char *const expected[] = {"ab", "cd", "||", "?", "?", "x", ""};
    for (size_t i = 0; i < sizeof expected / sizeof *expected; i++) {
        const SourceWord word = source_next(&reader);
        cr_expect_str_eq(word.text, expected[i]);
    }
}

Test(source_words, long_words_are_cut_off_but_stand_there_whole)
{
    char source[2 * SOURCE_WORD_BYTES + 1] = "";
    memset(source, 'a', sizeof source - 1);
    SourceReader reader = source_reader(source);
    const SourceWord word = source_next(&reader);
    cr_expect_eq(strlen(word.text), SOURCE_WORD_BYTES - 1);
    cr_expect_eq(word.length, sizeof source - 1);
}

Test(source_words, broken_texts_are_read_to_their_end)
{
    static const char *const broken[] = {
        "/*",       "/* *",       "\"",   "'",      "'\\", "\"\\", "\\",
        "#",        "#include <", "\\\n", "\\\r\n", "/",   "-",    "__attribute__((",
        "\xff\xfe", "?\?",        "?\?/", "<<",     "1e",  "1e+",  "."};
    for (size_t i = 0; i < sizeof broken / sizeof *broken; i++) {
        SourceReader reader = source_reader(broken[i]);
        int n_words = 0;
        while (source_next(&reader).kind != SOURCE_END && n_words < 100) {
            n_words++;
        }
        cr_expect_lt(n_words, 100, "\"%s\" does not end", broken[i]);
    }
    expect_words("a /* b", "a");
    expect_words("a \"b", "a \"b");
    expect_words("a '\\", "a '\\");
    expect_words("", "");
}

Test(source_words, macros_are_listed_but_for_those_behind_if_0)
{
    SourceReader reader =
        source_reader("#define a\n#if 0\n#define b\n#ifdef c\n#else\n#define d\n#endif\n#else\n"
                      "#define e\n#endif\n#if 0 || 1\n#define f(x) x\n#endif\n#if 0\n#endif\n"
                      "#define g\n#if 0\n#define h");
    static const char *const expected[] = {"a", "e", "f", "g", "", ""};
    for (size_t i = 0; i < sizeof expected / sizeof *expected; i++) {
        const SourceWord word = source_next_macro(&reader);
        cr_expect_str_eq(word.text, expected[i]);
    }
}
