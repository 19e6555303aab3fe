// tests/grader/settings: the command line of grade.
#include "settings.h"
#include "surroundings.h"

#include <getopt.h>
#include <inttypes.h>

#define MAX_WORDS 8

static void enter(void)
{
    folder_enter();
    mkdir("kernels", 0777);
    mkdir("labs", 0777);
    mkdir("labs/03-kdtree-2d-render", 0777);
}

TestSuite(settings, .init = enter, .fini = folder_leave);

// Parse a command line given as words, NULL after the last.
static int parse(const char *const words[MAX_WORDS], Settings *settings)
{
    char *argv[MAX_WORDS + 2] = {(char *)"grade"};
    int argc = 1;
    for (int i = 0; i < MAX_WORDS && words[i] != NULL; i++) {
        argv[argc++] = (char *)words[i];
    }
    optind = 0;  // start afresh
    return settings_parse(argc, argv, settings);
}

Test(settings, a_lab_is_found_by_number_or_name)
{
    static const char *const LABS[] = {"3", "03", "0003", "03-kdtree-2d-render"};
    for (size_t i = 0; i < sizeof LABS / sizeof LABS[0]; i++) {
        Settings settings;
        cr_assert_eq(parse((const char *[MAX_WORDS]){"--lab", LABS[i]}, &settings), 0);
        cr_expect_str_eq(settings.lab, "03-kdtree-2d-render");
        cr_expect_str_eq(settings.submission, "labs/03-kdtree-2d-render");
        cr_expect_str_eq(settings.output, "build/grade/03");
        cr_expect_eq(settings.time_limit, 0);
    }
}

Test(settings, drawn_seeds_have_64_bits)
{
    const char *const words[MAX_WORDS] = {"--lab=3"};
    Settings settings;
    uint64_t bits = 0, last = 0;
    for (int i = 0; i < 1000; i++) {
        cr_assert_eq(parse(words, &settings), 0);
        cr_expect_neq(settings.seed, last);
        bits |= last = settings.seed;
    }
    cr_expect_eq(bits, UINT64_MAX, "found %" PRIx64, bits);
}

Test(settings, everything_given)
{
    Settings settings;
    const char *first[MAX_WORDS] = {"--lab=3",    "--submission=a",      "--output=b",
                                    "--device=c", "--build=d",           "--time-limit=3600",
                                    "--seed",     "18446744073709551615"};
    cr_assert_eq(parse(first, &settings), 0);
    cr_expect_str_eq(settings.submission, "a");
    cr_expect_str_eq(settings.output, "b");
    cr_expect_str_eq(settings.device, "c");
    cr_expect_str_eq(settings.build, "d");
    cr_expect_eq(settings.time_limit, 3600);
    cr_expect_eq(settings.seed, UINT64_MAX);
    cr_expect_eq(settings.list_checks, 0);
}

static const struct {
    const char *words[MAX_WORDS];
    const char *message;
} BAD[] = {
    {{NULL}, "--lab is missing"},
    {{"--lab", ""}, "--lab: found \"\""},
    {{"--lab", "44"}, "--lab: found \"44\""},
    {{"--lab", "-3"}, "--lab: found \"-3\""},
    {{"--lab", "4294967299"}, "--lab: found \"4294967299\""},
    {{"--lab", "99999999999999999999"}, "--lab: found"},
    {{"--lab", "../labs"}, "--lab: found"},
    {{"--lab", "0*"}, "--lab: found"},
    {{"--lab", "3", "stray"}, "stray word"},
    {{"--lab", "3", "--device", ""}, "--device: found \"\""},
    {{"--seed", "0x10"}, "--seed: found \"0x10\""},
    {{"--seed", " 1"}, "--seed: found"},
    {{"--seed", "+1"}, "--seed: found"},
    {{"--seed", "-1"}, "--seed: found"},
    {{"--seed", ""}, "--seed: found"},
    {{"--seed", "18446744073709551616"}, "from 0 to 18446744073709551615"},
    {{"--time-limit", "0"}, "from 1 to 3600"},
    {{"--deadline", "0"}, "from 1 to 86400"},
    {{"--time-limit", "3601"}, "from 1 to 3600"},
    {{"--time-limit", "10s"}, "--time-limit: found \"10s\""},
};

Test(settings, bad_words_give_one_message)
{
    for (size_t i = 0; i < sizeof BAD / sizeof BAD[0]; i++) {
        Settings settings;
        cr_expect_eq(WITH_MESSAGE(BAD[i].message, parse(BAD[i].words, &settings)), -1,
                     "case %zu was taken", i);
    }
}

Test(settings, a_path_that_is_too_long)
{
    char path[PATH_MAX + 1];
    memset(path, 'a', sizeof path);
    path[PATH_MAX] = '\0';
    Settings settings;
    cr_expect_eq(
        WITH_MESSAGE("a path of over 4095 bytes",
                     parse((const char *[MAX_WORDS]){"--lab=3", "--output", path}, &settings)),
        -1);
}
