// grader/sandbox: which kind of walls works here, and what is said where none does.
#include "sandbox_commands.h"

#include <string.h>

TEST_EACH(choosing_is_silent_where_it_works)
{
    SandboxKind kind = SANDBOX_ANY;
    capture_begin(2);
    int status = sandbox_choose(tested_kind, &kind);
    cr_expect_str_eq(capture_end(2), "");
    cr_expect_eq(status, 0);
    cr_expect_eq(kind, tested_kind);
}

TEST_EACH(nothing_is_chosen_where_the_wanted_one_fails)
{
    SandboxKind kind = SANDBOX_ANY;
    setenv("PATH", "/nowhere", 1);
    setenv("TMPDIR", "/nowhere", 1);
    cr_expect_eq(WITH_MESSAGE(tested_kind == SANDBOX_BUBBLEWRAP
                                  ? "sandbox: bwrap not found: install bubblewrap"
                                  : "sandbox: cannot make a folder in $TMPDIR or /tmp",
                              sandbox_choose(tested_kind, &kind)),
                 -1);
}

// What bubblewrap does where there are no namespaces for it.
static void failing_bubblewrap_install(void)
{
    const char *failing =
        "#!/bin/sh\necho 'bwrap: No permissions to create new namespace' >&2\nexit 1\n";
    file_write("bwrap", failing, strlen(failing));
    cr_assert_eq(chmod("bwrap", 0755), 0);
    setenv("PATH", surroundings_folder, 1);
}

Test(bubblewrap, choosing_says_what_to_do_where_it_fails)
{
    SandboxKind kind = SANDBOX_ANY;
    failing_bubblewrap_install();
    capture_begin(2);
    int status = sandbox_choose(SANDBOX_BUBBLEWRAP, &kind);
    const char *message = capture_end(2);
    cr_expect_not_null(strstr(message, "sandbox: bwrap: No permissions"), "%s", message);
    cr_expect_not_null(strstr(message, "`make doctor` names"), "%s", message);
    cr_expect_eq(status, -1);
}

Test(landlock, is_chosen_where_bubblewrap_fails)
{
    if (geteuid() != 0) {
        SKIP_TEST("this sandbox needs root");
    }
    SandboxKind kind = SANDBOX_ANY;
    failing_bubblewrap_install();
    cr_expect_eq(WITH_MESSAGE("No permissions to create new namespace): Landlock is used",
                              sandbox_choose(SANDBOX_ANY, &kind)),
                 0);
    cr_expect_eq(kind, SANDBOX_LANDLOCK);
}

// In a process of its own, as an ordinary user cannot become root again.
static void expect_refusal_to_ordinary_user(void)
{
    SandboxKind kind = SANDBOX_ANY;
    if (geteuid() == 0) {
        cr_assert_eq(setresuid(65534, 65534, 65534), 0);
    }
    cr_expect_eq(WITH_MESSAGE("root", sandbox_choose(tested_kind, &kind)), -1);
    _exit(0);
}

Test(landlock, is_refused_to_an_ordinary_user)
{
    expect_refusal_to_ordinary_user();
}

Test(user, is_refused_to_an_ordinary_user)
{
    expect_refusal_to_ordinary_user();
}

Test(sandbox, none_is_never_chosen_by_itself)
{
    SandboxKind kind = SANDBOX_NONE;
    setenv("PATH", "/nowhere", 1);
    setenv("TMPDIR", "/nowhere", 1);
    capture_begin(2);
    int status = sandbox_choose(SANDBOX_ANY, &kind);
    const char *said = capture_end(2);
    cr_expect_eq(status, -1);
    cr_expect_neq(kind, SANDBOX_NONE);
    // But whoever cannot become root is told that it is enough for their own code.
    cr_expect_eq(strstr(said, "COURSE_SANDBOX=none") != NULL, geteuid() != 0, "%s", said);
}
