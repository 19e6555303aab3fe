// grader/stage: each file of the lab is taken from its best place in a submission.
#include "staged_files.h"

TestSuite(stage_places, .init = two_folders_enter, .fini = folder_leave);

// A file, with the folders above it, that holds its own path.
static void path_write(const char *path)
{
    char whole[4096];
    snprintf(whole, sizeof whole, "from/%s", path);
    for (char *slash = strchr(whole, '/'); slash != NULL; slash = strchr(slash + 1, '/')) {
        *slash = '\0';
        cr_assert(mkdir(whole, 0755) == 0 || access(whole, F_OK) == 0, "%s", whole);
        *slash = '/';
    }
    file_write(whole, path, strlen(path));
}

// Stage a.cl, and b.c where n_files is 2, of lab 03-x.
static int lab_stage(int n_files, char **message)
{
    Manifest manifest = {.lab = "03-x", .files = {"a.cl", "b.c"}, .n_files = n_files};
    return folder_stage(&manifest, "from", "to", message);
}

typedef struct Layout {
    const char *paths[4];  // what the submission holds
    const char *taken;     // which of them is staged as a.cl; NULL: none
    int status;
} Layout;

static const Layout layouts[] = {
    {{"a.cl", "labs/03-x/a.cl", "one/a.cl"}, "a.cl", 0},
    {{"labs/03-x/a.cl", "one/a.cl"}, "labs/03-x/a.cl", 0},
    {{"labs/02-w/a.cl", "labs/03-x/a.cl"}, "labs/03-x/a.cl", 0},
    {{"labs/02-w/a.cl", "one/a.cl"}, "one/a.cl", 0},
    {{"My Lab (2)/a.cl"}, "My Lab (2)/a.cl", 0},
    {{"one/two/a.cl", "two/a.cl"}, "two/a.cl", 0},
    // As GitHub packs a whole repository.
    {{"repo-main/labs/03-x/a.cl", "repo-main/solutions/03-x/a.cl"}, "repo-main/labs/03-x/a.cl", 0},
    {{"repo-main/labs/03-x/a.cl", "repo-main/a.cl"}, "repo-main/a.cl", 0},
    {{"repo-main/labs/03-x/a.cl", "one/two/a.cl"}, "repo-main/labs/03-x/a.cl", 0},
    {{"repo-main/labs/03-x/a.cl", "one/a.cl"}, "one/a.cl", 0},
    // Only the whole names count.
    {{"mylabs/03-x/a.cl", "one/a.cl"}, "one/a.cl", 0},
    {{"labs/03-x2/a.cl", "one/a.cl"}, "one/a.cl", 0},
    {{"one/xa.cl", "one/a.h"}, NULL, STAGE_NOTHING},
    // What is passed over.
    {{"__MACOSX/a.cl", "one/two/a.cl"}, "one/two/a.cl", 0},
    {{".git/a.cl", "build/a.cl", "one/.hidden/a.cl", "one/build/obj/a.cl"}, NULL, 1},
    // The deepest place, and one beyond it.
    {{"1/2/3/4/5/6/7/8/a.cl"}, "1/2/3/4/5/6/7/8/a.cl", 0},
    {{"1/2/3/4/5/6/7/8/9/a.cl"}, NULL, STAGE_NOTHING},
};

Test(stage_places, takes_a_file_from_its_best_place)
{
    for (size_t i = 0; i < sizeof layouts / sizeof *layouts; i++) {
        const Layout *layout = &layouts[i];
        for (int k = 0; k < 4 && layout->paths[k] != NULL; k++) {
            path_write(layout->paths[k]);
        }
        char *message;
        const int status = lab_stage(1, &message);
        cr_expect_eq(status, layout->status, "layout %zu: %d, %s", i, status, message);
        if (layout->taken != NULL) {
            expect_content("to/a.cl", layout->taken);
        } else {
            cr_expect_not_null(strstr(message, "a.cl: not in the submission"), "%s", message);
        }
        free(message);
        nftw("from", entry_remove, 16, FTW_DEPTH | FTW_PHYS);
    }
}

Test(stage_places, takes_each_file_from_its_own_best_place)
{
    path_write("old/a.cl");
    path_write("old/b.c");
    path_write("b.c");
    char *message;
    cr_assert_eq(lab_stage(2, &message), 0);
    expect_content("to/a.cl", "old/a.cl");
    expect_content("to/b.c", "b.c");
}

static void equal_write(const char *folder, const char *text)
{
    char path[512];
    snprintf(path, sizeof path, "from/%s", folder);
    cr_assert_eq(mkdir(path, 0755), 0);
    snprintf(path, sizeof path, "from/%s/a.cl", folder);
    file_write(path, text, strlen(text));
}

Test(stage_places, takes_equal_files_from_equally_good_places)
{
    equal_write("one", "kernel");
    equal_write("two", "kernel");
    char *message;
    cr_assert_eq(lab_stage(1, &message), 0);
    expect_content("to/a.cl", "kernel");
    cr_expect_str_eq(message, "a.cl: taken from \"one\"; the same is in \"two\"");
    free(message);
}

// ---- Names --------------------------------------------------------------------------------------

typedef struct Renamed {
    const char *paths[4];
    const char *says;
    const char *taken;  // NULL: none
    int status;
} Renamed;

static const Renamed renamed[] = {
    {{"a-1.cl"}, "a.cl: taken from \"a-1.cl\"", "a-1.cl", 0},
    {{"one/20261103102233_77_a.cl", 0},
     "a.cl: taken from \"one/20261103102233_77_a.cl\"",
     "one/20261103102233_77_a.cl",
     0},
    // The exact name comes first, wherever it is.
    {{"a (1).cl", "one/two/a.cl", 0},
     "a.cl: taken from \"one/two\"; a different one, which does not count, is in \"a (1).cl\"",
     "one/two/a.cl",
     0},
    {{"a (1).cl", "a-2.cl", 0},
     "a.cl: found in \"a-2.cl\" and, with another content, in \"a (1).cl\": hand in only one",
     NULL,
     1},
    // Of one system's uploads the last one counts.
    {{"a-2.cl", "a-10.cl", 0},
     "a.cl: taken from \"a-10.cl\"; an earlier upload, which does not count, is in \"a-2.cl\"",
     "a-10.cl",
     0},
    {{"one/a-2.cl", "two/a-1.cl", 0},
     "a.cl: found in \"one/a-2.cl\" and, with another content, in \"two/a-1.cl\": hand in only "
     "one",
     NULL,
     1},
    {{"one/a.cl.txt", "one/A.cl", 0},
     "a.cl: not in the submission: found \"one/A.cl\", expected the name a.cl: rename it and hand "
     "it in again",
     NULL,
     1},
    {{"a.cl.txt", "one/a.cl"}, NULL, "one/a.cl", 0},
    {{"a.cl.txt/main.c", 0},
     "a.cl: not in the submission, nor in a folder of it: hand in a file with exactly this name",
     NULL,
     STAGE_NOTHING},
    // What is passed over is told where there is nothing better.
    {{"build/a.cl", 0},
     "a.cl: not in the submission: found it in \"build\", which is passed over: hand it in outside "
     "of that folder",
     NULL,
     1},
    {{"one/.abgabe/x/a.cl", "Release/a.cl.txt", 0},
     "a.cl: not in the submission: found it in \"one/.abgabe/x\", which is passed over: hand it in "
     "outside of that folder",
     NULL,
     1},
    {{"build/a.cl", "SURNAME_a.cl", 0},
     "a.cl: not in the submission: found \"SURNAME_a.cl\", expected the name a.cl: rename it and "
     "hand it in again",
     NULL,
     1},
    {{"build/a.cl", "a.cl"}, NULL, "a.cl", 0},
};

Test(stage_places, takes_what_a_system_renamed_and_tells_what_a_student_did)
{
    for (size_t i = 0; i < sizeof renamed / sizeof *renamed; i++) {
        for (int k = 0; k < 4 && renamed[i].paths[k] != NULL; k++) {
            path_write(renamed[i].paths[k]);
        }
        char *message;
        cr_expect_eq(lab_stage(1, &message), renamed[i].status, "%zu", i);
        cr_expect_str_eq(message != NULL ? message : "",
                         renamed[i].says != NULL ? renamed[i].says : "");
        if (renamed[i].taken != NULL) {
            expect_content("to/a.cl", renamed[i].taken);
        }
        free(message);
        nftw("from", entry_remove, 16, FTW_DEPTH | FTW_PHYS);
    }
}

// ---- Several ------------------------------------------------------------------------------------

typedef struct Others {
    const char *paths[4];  // what the submission holds, each its own path but for those with "=",
                           // which hold "same"
    const char *says;
} Others;

Test(stage_places, says_which_was_taken_and_where_another_one_is)
{
    static const Others all[] = {
        {{"a.cl"}, NULL},
        {{"a.cl", "labs/03-x/a.cl", "one/a.cl"},
         "a.cl: taken from the top folder; a different one, which does not count, is in "
         "\"labs/03-x\""},
        {{"=a.cl", "=labs/03-x/a.cl"},
         "a.cl: taken from the top folder; the same is in \"labs/03-x\""},
        {{"=two/a.cl", "=one/a.cl", "x/y/a.cl", "x/z/a.cl"},
         "a.cl: taken from \"one\"; the same is in \"two\"; a different one, which does not "
         "count, is in \"x/y\""},
        {{"a.cl", "build/a.cl", ".git/a.cl", "__MACOSX/a.cl"}, NULL},
    };
    for (size_t i = 0; i < sizeof all / sizeof *all; i++) {
        for (int k = 0; k < 4 && all[i].paths[k] != NULL; k++) {
            const int is_same = all[i].paths[k][0] == '=';
            path_write(all[i].paths[k] + is_same);
            if (is_same) {
                char path[64];
                snprintf(path, sizeof path, "from/%s", all[i].paths[k] + 1);
                file_write(path, "same", 4);
            }
        }
        char *message;
        cr_expect_eq(lab_stage(1, &message), 0);
        cr_expect(all[i].says == NULL ? message == NULL
                                      : message != NULL && strcmp(message, all[i].says) == 0,
                  "%zu: %s", i, message);
        free(message);
        nftw("from", entry_remove, 16, FTW_DEPTH | FTW_PHYS);
    }
}

Test(stage_places, names_two_places_with_different_content)
{
    equal_write("three", "newer");
    equal_write("one", "kernel");
    equal_write("two", "kernel");
    expect_refused("a.cl", "a.cl: found in \"one\" and, with another content, in \"three\": hand");
    // The same size, and a place that cannot be read like a file.
    equal_write("four", "kernal");
    expect_refused("a.cl", "found in \"four\" and, with another content, in \"one\"");
    cr_assert_eq(unlink("from/four/a.cl"), 0);
    cr_assert_eq(mkdir("from/four/a.cl", 0755), 0);
    expect_refused("a.cl", "found in \"four\" and, with another content, in \"one\"");
}

Test(stage_places, refuses_too_many_equally_good_places)
{
    for (int i = 0; i < 17; i++) {
        char folder[16];
        snprintf(folder, sizeof folder, "copy-%d", i);
        equal_write(folder, "kernel");
    }
    expect_refused("a.cl", "found in more than 16 places");
    path_write("a.cl");
    char *message;
    cr_expect_eq(lab_stage(1, &message), 0, "a better place does not end that: %s", message);
    cr_expect_str_eq(message, "a.cl: taken from the top folder; a different one, which does not "
                              "count, is in \"copy-0\"");
    free(message);
}

Test(stage_places, says_what_counts_no_more_than_an_empty_file)
{
    path_write("labs/03-x/a.cl");
    file_write("from/a.cl", "\n", 1);
    char *message;
    cr_assert_eq(lab_stage(1, &message), 1);
    const char *second = strchr(message, '\n');
    cr_assert_not_null(second, "%s", message);
    cr_expect_str_eq(second + 1, "a.cl: another one, which does not count, is in \"labs/03-x\"");
    free(message);
}

Test(stage_places, shows_names_that_are_fit_for_a_terminal)
{
    char longest[256];
    memset(longest, 'x', 255);
    longest[255] = '\0';
    equal_write("a\nb\x1b[2J\xc3\x9c", "one");
    equal_write(longest, "two");
    char *message = NULL;
    cr_assert_eq(lab_stage(1, &message), 1);
    cr_expect_not_null(strstr(message, "\"a\\x0Ab\\x1B[2J\xc3\x9c\""), "%s", message);
    cr_expect_not_null(strstr(message, "\"xxxx"), "%s", message);
    cr_expect_not_null(strstr(message, "x...x"), "%s", message);
    cr_expect_lt(strlen(message), 300);
    cr_expect_null(strchr(message, '\n'));
    free(message);
}

Test(stage_places, enters_no_folder_through_a_link)
{
    cr_assert_eq(mkdir("elsewhere", 0755), 0);
    file_write("elsewhere/a.cl", "secret", 6);
    cr_assert_eq(symlink("../elsewhere", "from/folder"), 0);
    cr_assert_eq(symlink("..", "from/loop"), 0);
    cr_assert_eq(symlink("../elsewhere", "from/labs"), 0);
    expect_refused("a.cl", "not in the submission");
}

Test(stage_places, passes_over_a_folder_nobody_may_read)
{
    if (geteuid() == 0) {
        SKIP_TEST("root may read everything");
    }
    path_write("locked/a.cl");
    path_write("one/two/a.cl");
    cr_assert_eq(chmod("from/locked", 0), 0);
    char *message;
    cr_expect_eq(lab_stage(1, &message), 0);
    cr_assert_eq(chmod("from/locked", 0755), 0);
    expect_content("to/a.cl", "one/two/a.cl");
}

Test(stage_places, finds_a_file_among_a_hundred_thousand)
{
    // Links are made faster than files, and are as many entries.
    char path[256], filler[201];
    memset(filler, 'y', sizeof filler - 1);
    filler[sizeof filler - 1] = '\0';
    path_write("one/a.cl");
    file_write("from/filler", "", 0);
    for (int i = 0; i < 100000; i++) {
        snprintf(path, sizeof path, "from/%s-%d", filler, i);
        if (i % 30000 == 0) {
            snprintf(path, sizeof path, "from/filler-%d", i);
            file_write(path, "", 0);
        } else {
            char first[64];
            snprintf(first, sizeof first, "from/filler-%d", i / 30000 * 30000);
            cr_assert_eq(link(first, path), 0, "%s", path);
        }
    }
    char *message;
    cr_expect_eq(lab_stage(1, &message), 0);
    expect_content("to/a.cl", "one/a.cl");
}
