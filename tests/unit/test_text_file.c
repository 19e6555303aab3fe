// common/text_file: whole text files, or one message.
#include "surroundings.h"
#include "text_file.h"

TestSuite(text_file, .init = folder_enter, .fini = folder_leave);

Test(text_file, the_text_is_read_whole)
{
    static const char *const TEXTS[] = {"", "\n", "one line", "two\nlines\n", "\xff\r\n"};
    for (size_t i = 0; i < sizeof TEXTS / sizeof TEXTS[0]; i++) {
        file_write("a.txt", TEXTS[i], strlen(TEXTS[i]));
        char *text = text_file_read("a.txt");
        cr_assert_not_null(text);
        cr_expect_str_eq(text, TEXTS[i]);
        free(text);
    }
}

Test(text_file, a_line_has_a_number_from_1_on)
{
    size_t length;
    static const char text[] = "one\n\nthree\n";
    cr_expect_eq(text_line(text, 1, &length), text);
    cr_expect_eq(length, 3);
    cr_expect_eq(text_line(text, 2, &length), text + 4);
    cr_expect_eq(length, 0);
    cr_expect_eq(text_line(text, 3, &length), text + 5);
    cr_expect_eq(length, 5);
    cr_expect_null(text_line(text, 4, &length));
    cr_expect_null(text_line(text, 1000, &length));
    cr_expect_null(text_line("", 1, &length));
    cr_expect_eq(text_line("last", 1, &length)[length], '\0');
}

Test(text_file, a_nul_byte_is_no_text)
{
    static const char *const TEXTS[] = {"\0bc", "a\0c", "ab\0"};
    for (size_t i = 0; i < sizeof TEXTS / sizeof TEXTS[0]; i++) {
        file_write("a.txt", TEXTS[i], 3);
        capture_begin(2);
        char *text = text_file_read("a.txt");
        expect_one_message(capture_end(2), "a.txt: cannot be read: found a NUL byte");
        cr_expect_null(text);
        free(text);
    }
}

Test(text_file, what_cannot_be_read)
{
    mkdir("folder", 0777);
    static const char *const PATHS[] = {"missing", "folder", "folder/missing"};
    for (size_t i = 0; i < sizeof PATHS / sizeof PATHS[0]; i++) {
        capture_begin(2);
        char *text = text_file_read(PATHS[i]);
        const char *message = capture_end(2);
        expect_one_message(message, PATHS[i]);
        expect_one_message(message, ": cannot be read: ");
        cr_expect_null(text);
        free(text);
    }
}

// A pipe without a writer would be waited for; the test's time limit would end that.
Test(text_file, what_is_no_file_is_refused_at_once, .timeout = 600)
{
    mkdir("folder", 0777);
    cr_assert_eq(mkfifo("pipe", 0600), 0);
    cr_assert_eq(symlink("pipe", "link"), 0);
    static const struct {
        const char *path, *message;
    } CASES[] = {
        {"pipe", "pipe: cannot be read: found a pipe or a device, expected a regular file"},
        {"link", "link: cannot be read: found a pipe or a device, expected a regular file"},
        {"/dev/zero", "/dev/zero: cannot be read: found a pipe or a device"},
        {"folder", "folder: cannot be read: found a folder, expected a file"},
    };
    for (size_t i = 0; i < sizeof CASES / sizeof CASES[0]; i++) {
        capture_begin(2);
        FILE *file = text_file_open(CASES[i].path);
        expect_one_message(capture_end(2), CASES[i].message);
        cr_expect_null(file);
    }
}

Test(text_file, a_link_to_a_file_is_fine)
{
    file_write("a.txt", "text", 4);
    cr_assert_eq(symlink("a.txt", "link"), 0);
    FILE *file = text_file_open("link");
    cr_assert_not_null(file);
    cr_expect_eq(getc(file), 't');
    fclose(file);
}
