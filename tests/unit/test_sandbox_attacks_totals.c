// grader/sandbox: attacks that take more than all processes of a run together may, behind every
// kind of walls. Each is bounded by itself: at most 2000 forks, 1 GB of memory, 320 MB of files,
// 20 000 mappings.
#include "sandbox_commands.h"

TEST_EACH(a_fork_bomb_is_named)
{
    expect_exceeded(perl_run("for (1..2000) { my $id = fork; if (defined $id && !$id) { sleep 20; "
                             "exit } } sleep 20"),
                    SANDBOX_LIMIT_PROCESSES);
}

TEST_EACH(memory_of_many_processes_is_summed_up)
{
    // Each within its own limit.
    expect_exceeded(perl_run("for (1..10) { if (!fork) { my $x = chr(1) x 1e8; sleep 20; exit } } "
                             "sleep 20"),
                    SANDBOX_LIMIT_MEMORY);
    // What a process and its children share is counted once.
    expect_exit(perl_run("my $x = chr(1) x 5e7; for (1..7) { if (!fork) { sleep 1; exit } } "
                         "sleep 1; exit 3"),
                3);
}

TEST_EACH(files_are_summed_up)
{
    expect_exceeded(shell_run("for i in $(seq 40); do head -c 8M /dev/zero >$i; done; sleep 20"),
                    SANDBOX_LIMIT_BYTES);
}

TEST_EACH(files_written_just_before_the_end_count)
{
    expect_exceeded(shell_run("for i in $(seq 40); do head -c 8M /dev/zero >$i; done"),
                    SANDBOX_LIMIT_BYTES);
}

TEST_EACH(removed_files_count_as_long_as_they_are_open)
{
    expect_exceeded(
        perl_run("my $x = chr(1) x 8e6; my @f; for (1..40) { open(my $f, q(>), q(own)); "
                 "unlink q(own); print $f $x; $f->flush; push @f, $f } sleep 20"),
        SANDBOX_LIMIT_BYTES);
}

// One whose name ends like that of shared memory is a file all the same.
TEST_EACH(removed_files_count_as_long_as_a_page_is_mapped)
{
    const char *source =
        "#include <fcntl.h>\n#include <sys/mman.h>\n#include <unistd.h>\nstatic char x[8000000];"
        "int main(int n, char **v) { x[0] = 1; for (int i = 0; i < 20; i++) { int f = open(v[1], "
        "O_RDWR | "
        "O_CREAT, 0600); unlink(v[1]); write(f, x, sizeof x); "
        "mmap((void *)(65536L << i), 4096, PROT_READ, MAP_SHARED, f, 0); close(f); } sleep(20); }";
    file_write("held.c", source, strlen(source));
    expect_exceeded(shell_run("gcc -w held.c -o held && exec ./held own"), SANDBOX_LIMIT_BYTES);
    expect_exceeded(shell_run("mkdir -p 'a /dev' && exec ./held 'a /dev/zero'"),
                    SANDBOX_LIMIT_BYTES);
}

// Memory that processes share is there until the last page of it is unmapped.
TEST_EACH(shared_memory_counts_as_long_as_a_page_is_mapped)
{
    const char *source =
        "#include <string.h>\n#include <sys/mman.h>\n#include <unistd.h>\n"
        "int main(void) { size_t n = 100 << 20; for (int i = 0; i < 8; i++) { char *p = mmap(0, n, "
        "PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0); memset(p, 1, n); "
        "munmap(p + 4096, n - 4096); } sleep(20); }";
    if (geteuid() != 0) {
        SKIP_TEST("only root is told how much it is");
    }
    file_write("held.c", source, strlen(source));
    expect_exceeded(shell_run("gcc -w held.c -o held && exec ./held"), SANDBOX_LIMIT_MEMORY);
}

// Each page has other rights than the one before: a mapping of its own.
static const char *many_mappings =
    "#include <stdlib.h>\n#include <sys/mman.h>\n#include <unistd.h>\n"
    "int main(int c, char **v) { int n = atoi(v[1]); char *p = mmap(0, n * 4096L, PROT_NONE, "
    "MAP_PRIVATE | MAP_ANONYMOUS, -1, 0); for (int i = 0; i < n; i += 2) "
    "mprotect(p + i * 4096L, 4096, PROT_READ); sleep(atoi(v[2])); return 3; }";

TEST_EACH(many_mappings_are_stopped)
{
    file_write("many.c", many_mappings, strlen(many_mappings));
    expect_exceeded(shell_run("gcc -w many.c -o many && exec ./many 20000 20"),
                    SANDBOX_LIMIT_MAPPINGS);
    // Each within the limit, but not all together.
    expect_exceeded(shell_run("for i in 1 2 3 4 5; do ./many 4000 20 & done; wait"),
                    SANDBOX_LIMIT_MAPPINGS);
    expect_exit(shell_run("exec ./many 8000 1"), 3);
}

// A line of the list is as long as the file's name.
TEST_EACH(mappings_with_long_names_count_as_several)
{
    const char *source =
        "#include <fcntl.h>\n#include <string.h>\n#include <sys/mman.h>\n#include <sys/stat.h>\n"
        "#include <unistd.h>\n"
        "int main(void) { char name[251] = \"\"; memset(name, 'x', 250); for (int i = 0; i < 12; "
        "i++) { mkdir(name, 0700); chdir(name); } int f = open(\"f\", O_RDWR | O_CREAT, 0600); "
        "for (int i = 0; i < 3000; i++) mmap(0, 4096, PROT_READ, MAP_SHARED, f, i % 2 * 8192); "
        "sleep(20); }";
    file_write("long.c", source, strlen(source));
    expect_exceeded(shell_run("gcc -w long.c -o long && exec ./long"), SANDBOX_LIMIT_MAPPINGS);
}

TEST_EACH(many_open_files_are_stopped)
{
    expect_exceeded(
        perl_run("for (1..19) { fork or last } my @f; "
                 "for (1..240) { open(my $f, q(<), q(/dev/null)) or last; push @f, $f } "
                 "sleep 20"),
        SANDBOX_LIMIT_OPEN_FILES);
}

TEST_EACH(signals_that_wait_and_timers_are_limited)
{
    const char *source =
        "#include <signal.h>\n#include <time.h>\n#include <unistd.h>\n"
        "int main(void) { int n = 0; timer_t timer; struct sigevent none = {.sigev_notify = "
        "SIGEV_NONE}; while (n < 5000 && timer_create(CLOCK_MONOTONIC, &none, &timer) == 0) n++; "
        "return n <= 1024 ? 3 : 4; }";
    file_write("timers.c", source, strlen(source));
    expect_exit(shell_run("gcc -w timers.c -o timers && exec ./timers"), 3);
}

// A process goes on without its first thread, and without any that lives longer than a moment.
static const char *without_first_thread =
    "#include <pthread.h>\n#include <stdlib.h>\n#include <string.h>\n#include <unistd.h>\n"
    "void *next(void *n) { pthread_t t; pthread_detach(pthread_self());"
    "if (n == (void *)1) { sleep(20); _exit(0); }"
    "usleep(100); if (pthread_create(&t, 0, next, (char *)n - 1) != 0) _exit(1); return 0; }"
    "int main(int c, char **v) { int i = atoi(v[1]); while (--i > 0 && fork() != 0);"
    "int n = atoi(v[2]) << 20; memset(malloc(n), 1, n);"
    "pthread_t t; pthread_create(&t, 0, next, (void *)atol(v[3])); pthread_exit(0); }";

TEST_EACH(memory_counts_when_the_first_thread_has_ended)
{
    file_write("first.c", without_first_thread, strlen(without_first_thread));
    expect_exceeded(shell_run("gcc -w first.c -o first && exec ./first 10 100 1"),
                    SANDBOX_LIMIT_MEMORY);
    expect_exceeded(shell_run("exec ./first 10 100 20000"), SANDBOX_LIMIT_MEMORY);
}

TEST_OWN_USER(who_is_left_without_a_first_thread_is_counted)
{
    file_write("first.c", without_first_thread, strlen(without_first_thread));
    SandboxResult result = shell_run("gcc -w first.c -o first; ./first 1 1 1 & sleep 1; exit 3");
    cr_expect_eq(result.n_left, 1, "%d", result.n_left);
    expect_exit(result, 3);
}

TEST_EACH(many_files_are_stopped)
{
    expect_exceeded(perl_run("for (1..3000) { open(my $f, q(>), $_) } sleep 20"),
                    SANDBOX_LIMIT_FILES);
}

TEST_EACH(files_in_its_temporary_folder_count)
{
    expect_exceeded(perl_run("for (1..3000) { open(my $f, q(>), qq($ENV{TMPDIR}/$_)) } sleep 20"),
                    SANDBOX_LIMIT_FILES);
}

TEST_EACH(deep_folders_hide_nothing)
{
    expect_exceeded(perl_run("for (1..60) { mkdir q(a); chdir q(a) } sleep 20"),
                    SANDBOX_LIMIT_FILES);
}

TEST_EACH(links_lead_the_scan_nowhere)
{
    expect_exit(shell_run("ln -s / root; ln -s . self; ln -s /usr/lib lib; sleep 0.5; exit 3"), 3);
}
