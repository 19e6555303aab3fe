// grader/secrets: is what a submission must not read closed to users without rights?
#include "secrets.h"

#include "surroundings.h"

// A course of one lab and a class, below a folder that everybody may enter.
static void course_enter(void)
{
    folder_enter();
    static const char *const folders[] = {
        "course",       "course/solutions", "course/solutions/01-naive-2d",
        "course/tests", "course/build",     "class",
        "class/ada",    "class/bob",        "marks"};
    cr_assert_eq(chmod(".", 0755), 0);
    for (size_t i = 0; i < sizeof folders / sizeof *folders; i++) {
        cr_assert_eq(mkdir(folders[i], 0755) | chmod(folders[i], 0755), 0);
    }
    cr_assert_eq(chdir("course"), 0);
}

TestSuite(secrets, .init = course_enter, .fini = folder_leave);

static const Settings settings = {
    .lab = "01-naive-2d",
    .submission = "../class/ada",
    .output = "../marks/ada",
    .build = "build",
};

// Check, and see the status. Returns what was said.
static const char *check(const Settings *checked, int expected)
{
    capture_begin(2);
    const int status = secrets_check(checked);
    const char *said = capture_end(2);
    cr_expect_eq(status, expected, "%s", said);
    return said;
}

Test(secrets, an_open_course_is_refused_and_closed_as_it_is_said)
{
    if (geteuid() != 0) {
        SKIP_TEST("whoever is not root cannot ask what others may read");
    }
    const char *said = check(&settings, -1);
    cr_expect_not_null(strstr(said, "/course/solutions/01-naive-2d\n"), "%s", said);
    cr_expect_not_null(strstr(said, "/class\n"), "%s", said);
    cr_expect_not_null(strstr(said, "/marks\n"), "%s", said);
    // The commands that are printed close it.
    int n_commands = 0;
    char commands[4096];
    snprintf(commands, sizeof commands, "%s", said);
    for (char *line = commands; (line = strstr(line, "      chmod ")) != NULL; n_commands++) {
        char command[1024];
        const size_t length = strcspn(line, "\n");
        snprintf(command, sizeof command, "%.*s", (int)length, line);
        cr_expect_eq(system(command), 0, "%s", command);
        line += length;
    }
    cr_expect_eq(n_commands, 3, "%s", commands);
    cr_expect_str_eq(check(&settings, 0), "");
}

Test(secrets, each_of_them_counts)
{
    if (geteuid() != 0) {
        SKIP_TEST("whoever is not root cannot ask what others may read");
    }
    static const char *const folders[] = {".", "../class", "../marks"};
    for (int open = 0; open < 3; open++) {
        for (int i = 0; i < 3; i++) {
            cr_assert_eq(chmod(folders[i], i == open ? 0755 : 0700), 0);
        }
        check(&settings, -1);
        // Passable is open to whoever knows a name.
        cr_assert_eq(chmod(folders[open], 0711), 0);
        check(&settings, -1);
    }
}

// As /tmp: nobody's own, so that only the submission itself is asked about and to be closed.
Test(secrets, a_folder_of_everybodys_need_not_be_closed)
{
    if (geteuid() != 0) {
        SKIP_TEST("whoever is not root cannot ask what others may read");
    }
    cr_assert_eq(chmod(".", 0700) | chmod("../marks", 0700) | chmod("../class", 01777), 0);
    const char *said = check(&settings, -1);
    cr_expect_not_null(strstr(said, "/class/ada'\n"), "%s", said);
    cr_assert_eq(chmod("../class/ada", 0700), 0);
    check(&settings, 0);
}

Test(secrets, answers_that_are_kept_are_secrets)
{
    if (geteuid() != 0) {
        SKIP_TEST("whoever is not root cannot ask what others may read");
    }
    Settings keeping = settings;
    keeping.kept_answers = "../answers/01";
    cr_assert_eq(mkdir("../answers", 0755) | mkdir("../answers/01", 0755), 0);
    cr_assert_eq(chmod(".", 0700) | chmod("../marks", 0700) | chmod("../class", 0700), 0);
    const char *said = check(&keeping, -1);
    cr_expect_not_null(strstr(said, "/answers'\n"), "%s", said);
    cr_assert_eq(chmod("../answers", 0700), 0);
    check(&keeping, 0);
}
