// probes/sections: what was written comes back, and a file made to mislead is not believed.
#include "sections.h"
#include "surroundings.h"

#include <stddef.h>
#include <stdint.h>
#include <sys/stat.h>

TestSuite(sections, .init = folder_enter, .fini = folder_leave);

enum { MAX_BYTES = 1 << 20 };

static void section_append(const char *name, const void *bytes, size_t n_bytes)
{
    FILE *file = fopen("file", "ab");
    cr_assert_not_null(file);
    cr_assert_eq(section_write(file, name, bytes, n_bytes), 0);
    fclose(file);
}

// A section's header as an attacker may write it, with `n_following` bytes after it.
static void raw_append(const char name[SECTION_NAME_BYTES], uint64_t n_bytes, size_t n_following)
{
    FILE *file = fopen("file", "ab");
    cr_assert_not_null(file);
    fwrite(name, 1, SECTION_NAME_BYTES, file);
    fwrite(&n_bytes, sizeof n_bytes, 1, file);
    for (size_t i = 0; i < n_following; i++) {
        fputc('x', file);
    }
    fclose(file);
}

static const char named_b[SECTION_NAME_BYTES] = "b";

Test(sections, come_back_as_written_and_aligned)
{
    // Sizes around the alignment.
    for (size_t n_bytes = 0; n_bytes <= 40; n_bytes++) {
        char name[SECTION_NAME_BYTES];
        unsigned char bytes[40];
        memset(bytes, (int)n_bytes, sizeof bytes);
        snprintf(name, sizeof name, "section %zu", n_bytes);
        section_append(name, bytes, n_bytes);
    }
    Sections sections;
    cr_assert_eq(sections_load("file", MAX_BYTES, &sections), 0);
    for (size_t n_bytes = 0; n_bytes <= 40; n_bytes++) {
        char name[SECTION_NAME_BYTES];
        snprintf(name, sizeof name, "section %zu", n_bytes);
        const unsigned char *bytes = sections_find(&sections, name, n_bytes);
        cr_assert_not_null(bytes, "%s", name);
        cr_expect_eq((uintptr_t)bytes % _Alignof(max_align_t), 0);
        for (size_t i = 0; i < n_bytes; i++) {
            cr_expect_eq(bytes[i], n_bytes);
        }
    }
    sections_free(&sections);
}

Test(sections, are_flushed_one_by_one)
{
    FILE *file = fopen("file", "wb");
    cr_assert_eq(section_write(file, "a", "1234", 4), 0);
    Sections sections;
    cr_expect_eq(sections_load("file", MAX_BYTES, &sections), 0);
    cr_expect_not_null(sections_find(&sections, "a", 4));
    sections_free(&sections);
    fclose(file);
}

Test(sections, are_found_by_exact_name_and_size)
{
    section_append("abc", "1234", 4);
    Sections sections;
    cr_assert_eq(sections_load("file", MAX_BYTES, &sections), 0);
    size_t n_bytes = 0;
    cr_expect_not_null(sections_find_any(&sections, "abc", &n_bytes));
    cr_expect_eq(n_bytes, 4);
    cr_expect_null(sections_find(&sections, "abc", 3));
    cr_expect_null(sections_find(&sections, "abc", 16));
    cr_expect_null(sections_find(&sections, "ab", 4));
    cr_expect_null(sections_find(&sections, "abcd", 4));
    cr_expect_null(sections_find(&sections, "", 4));
    cr_expect_null(sections_find(&sections, "a name that is longer than any may be", 4));
    sections_free(&sections);
}

Test(sections, given_twice_count_as_absent)
{
    section_append("a", "1234", 4);
    section_append("b", "1234", 4);
    section_append("a", "12345", 5);
    Sections sections;
    cr_assert_eq(sections_load("file", MAX_BYTES, &sections), 0);
    cr_expect_null(sections_find(&sections, "a", 4));
    cr_expect_null(sections_find(&sections, "a", 5));
    cr_expect_not_null(sections_find(&sections, "b", 4));
    sections_free(&sections);
}

Test(sections, need_a_name_of_1_to_23_bytes)
{
    FILE *file = fopen("file", "wb");
    cr_expect_eq(section_write(file, "", "x", 1), -1);
    cr_expect_eq(section_write(file, "123456789012345678901234", "x", 1), -1);
    cr_expect_eq(section_write(file, "12345678901234567890123", "x", 1), 0);
    fclose(file);
    Sections sections;
    cr_expect_eq(sections_load("file", MAX_BYTES, &sections), 0);
    cr_expect_not_null(sections_find(&sections, "12345678901234567890123", 1));
    sections_free(&sections);
}

Test(sections, tell_when_writing_fails)
{
    FILE *file = fopen("/dev/full", "wb");
    cr_assert_not_null(file);
    cr_expect_eq(section_write(file, "a", "1234", 4), -1);
    fclose(file);
}

Test(sections, an_empty_file_is_an_empty_list)
{
    file_write("file", "", 0);
    Sections sections;
    cr_expect_eq(sections_load("file", MAX_BYTES, &sections), 0);
    cr_expect_null(sections_find(&sections, "a", 0));
    sections_free(&sections);
}

// What was whole before the damage can still be read.
static void expect_cut_off_after_a(void)
{
    Sections sections;
    cr_expect_eq(sections_load("file", MAX_BYTES, &sections), -1);
    cr_expect_not_null(sections_find(&sections, "a", 4));
    cr_expect_null(sections_find(&sections, "b", 8));
    sections_free(&sections);
}

Test(sections, a_file_cut_off_anywhere_keeps_its_whole_sections)
{
    section_append("a", "1234", 4);
    struct stat status;
    cr_assert_eq(stat("file", &status), 0);
    off_t end_of_a = status.st_size;
    section_append("b", "12345678", 8);
    cr_assert_eq(stat("file", &status), 0);
    for (off_t size = status.st_size - 1; size > end_of_a; size--) {
        cr_assert_eq(truncate("file", size), 0);
        expect_cut_off_after_a();
    }
}

Test(sections, sizes_beyond_the_file_are_not_believed)
{
    const uint64_t sizes[] = {33,        1u << 31,        UINT32_MAX,      (uint64_t)1 << 32,
                              INT64_MAX, UINT64_MAX - 63, UINT64_MAX - 15, UINT64_MAX - 14,
                              UINT64_MAX};
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++) {
        unlink("file");
        section_append("a", "1234", 4);
        raw_append(named_b, sizes[i], 32);
        expect_cut_off_after_a();
    }
}

Test(sections, names_without_an_end_or_with_a_tail_match_nothing)
{
    char endless[SECTION_NAME_BYTES];
    memset(endless, 'a', sizeof endless);
    raw_append(endless, 0, 0);
    char with_tail[SECTION_NAME_BYTES] = "a\0tail";
    raw_append(with_tail, 0, 0);
    Sections sections;
    cr_assert_eq(sections_load("file", MAX_BYTES, &sections), 0);
    cr_expect_null(sections_find(&sections, "a", 0));
    cr_expect_null(sections_find(&sections, "aaaaaaaaaaaaaaaaaaaaaaa", 0));
    cr_expect_null(sections_find(&sections, "aaaaaaaaaaaaaaaaaaaaaaaa", 0));
    sections_free(&sections);
}

Test(sections, any_bytes_are_read_without_harm)
{
    // Random files, and random damage to a good one: nothing to expect but the sanitizers' silence.
    srand(1);
    for (int round = 0; round < 2000; round++) {
        unlink("file");
        section_append("a", "1234", 4);
        section_append("b", "12345678", 8);
        FILE *file = fopen("file", "r+b");
        for (int i = 0; i < 1 + round % 8; i++) {
            fseek(file, rand() % 112, SEEK_SET);
            fputc(rand() & 255, file);
        }
        fclose(file);
        Sections sections;
        size_t n_bytes;
        sections_load("file", MAX_BYTES, &sections);
        const unsigned char *bytes = sections_find_any(&sections, "b", &n_bytes);
        unsigned sum = 0;
        for (size_t i = 0; bytes != NULL && i < n_bytes; i++) {
            sum += bytes[i];
        }
        cr_expect(sum < UINT32_MAX);
        sections_free(&sections);
    }
}

static void expect_refused(const char *path, size_t max_bytes)
{
    Sections sections;
    cr_expect_eq(sections_load(path, max_bytes, &sections), -1, "%s", path);
    cr_expect_null(sections_find(&sections, "a", 4));
    sections_free(&sections);
}

Test(sections, only_a_regular_file_is_read)
{
    section_append("a", "1234", 4);
    cr_assert_eq(symlink("file", "link"), 0);
    cr_assert_eq(mkfifo("fifo", 0644), 0);
    cr_assert_eq(mkdir("folder", 0755), 0);
    expect_refused("link", MAX_BYTES);
    expect_refused("fifo", MAX_BYTES);
    expect_refused("folder", MAX_BYTES);
    expect_refused("absent", MAX_BYTES);
    expect_refused("/dev/zero", MAX_BYTES);
}

Test(sections, a_file_over_the_limit_is_refused)
{
    section_append("a", "1234", 4);  // 48 bytes
    expect_refused("file", 47);
    Sections sections;
    cr_expect_eq(sections_load("file", 48, &sections), 0);
    sections_free(&sections);
    cr_assert_eq(truncate("file", (off_t)1 << 40), 0);
    expect_refused("file", MAX_BYTES);
}
