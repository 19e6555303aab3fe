// Unit tests of the manifest reader: what is right is read whole, and each slip is named in one
// message.
#include "manifest.h"

#include <criterion/criterion.h>
#include <criterion/redirect.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#define TASK_A                                                                                     \
    "{\"id\": \"a\", \"file\": \"a.cl\", \"title\": \"A?\", \"points\": {\"a-far\": 30, "          \
    "\"a-near\": 10}, \"hint\": \"h\"}"
#define TASK_B                                                                                     \
    "{\"id\": \"b\", \"file\": \"b.cl\", \"title\": \"B?\", \"points\": {\"b\": 60}, \"hint\": "   \
    "\"h\"}"
#define FILES "\"files\": [\"a.cl\", \"b.cl\"]"
#define MANIFEST(files, tasks) "{\"title\": \"T\", " files ", \"tasks\": [" tasks "]}"

// A labs' folder with one lab, "01-x", whose lab.json holds `text` (none when NULL).
static void lab_write(const char *text, char *folder)
{
    strcpy(folder, "/tmp/test-manifest-XXXXXX");
    cr_assert_not_null(mkdtemp(folder));
    char path[128];
    snprintf(path, sizeof path, "%s/01-x", folder);
    cr_assert_eq(mkdir(path, 0700), 0);
    if (text == NULL) {
        return;
    }
    snprintf(path, sizeof path, "%s/01-x/lab.json", folder);
    FILE *file = fopen(path, "w");
    cr_assert_not_null(file);
    fputs(text, file);
    fclose(file);
}

static void lab_remove(const char *folder)
{
    char path[128];
    snprintf(path, sizeof path, "%s/01-x/lab.json", folder);
    unlink(path);
    snprintf(path, sizeof path, "%s/01-x", folder);
    rmdir(path);
    rmdir(folder);
}

// What was written to stderr so far.
static void stderr_read(char *text, size_t size)
{
    fflush(stderr);
    FILE *written = cr_get_redirected_stderr();
    size_t length = fread(text, 1, size - 1, written);
    text[length] = '\0';
}

Test(manifest, reads_every_field)
{
    char folder[64];
    lab_write(MANIFEST(FILES, TASK_A ", " TASK_B), folder);
    Manifest manifest;
    cr_assert_eq(manifest_load(folder, "01-x", &manifest), 0);
    lab_remove(folder);

    cr_expect_str_eq(manifest.lab, "01-x");
    cr_expect_str_eq(manifest.title, "T");
    cr_assert_eq(manifest.n_files, 2);
    cr_expect_str_eq(manifest.files[1], "b.cl");
    cr_assert_eq(manifest.n_tasks, 2);
    const Task *task = manifest_task(&manifest, "b");
    cr_assert_eq(task, &manifest.tasks[1]);
    cr_expect_str_eq(task->file, "b.cl");
    cr_expect_str_eq(task->title, "B?");
    cr_expect_str_eq(task->hint, "h");
    cr_assert_eq(task->n_checks, 1);
    cr_expect_str_eq(task->checks[0].id, "b");
    cr_expect_eq(task->checks[0].points, 60);
    task = &manifest.tasks[0];
    cr_assert_eq(task->n_checks, 2);
    cr_expect_str_eq(task->checks[1].id, "a-near");
    cr_expect_eq(task->checks[1].points, 10);
    cr_expect_null(manifest_task(&manifest, "c"));
    manifest_free(&manifest);
    cr_expect_eq(manifest.n_tasks, 0);
}

#define HINTS(hints)                                                                               \
    "{\"id\": \"a\", \"file\": \"a.cl\", \"title\": \"A?\", "                                      \
    "\"points\": {\"a-far\": 60, \"a-near\": 40}, \"hint\": \"h\", \"hints\": " hints "}"

Test(manifest, a_check_may_have_a_hint_of_its_own)
{
    char folder[64];
    lab_write(MANIFEST(FILES, HINTS("{\"a-far\": \"Look far.\"}")), folder);
    Manifest manifest;
    cr_assert_eq(manifest_load(folder, "01-x", &manifest), 0);
    lab_remove(folder);
    cr_expect_str_eq(manifest_hint(&manifest.tasks[0], "a-far"), "Look far.");
    cr_expect_str_eq(manifest_hint(&manifest.tasks[0], "a-near"), "h");
    manifest_free(&manifest);
}

#define BOARD(files, leaderboard)                                                                  \
    "{\"title\": \"T\", " files ", \"tasks\": [" TASK_A ", " TASK_B                                \
    "], \"leaderboard\": " leaderboard "}"

Test(manifest, a_lab_may_have_a_leaderboard)
{
    static const struct {
        const char *text, *leaderboard;
    } cases[] = {{BOARD(FILES, "\"times as fast\""), "times as fast"},
                 {MANIFEST(FILES, TASK_A ", " TASK_B), NULL}};
    for (size_t i = 0; i < 2; i++) {
        char folder[64];
        lab_write(cases[i].text, folder);
        Manifest manifest;
        cr_assert_eq(manifest_load(folder, "01-x", &manifest), 0);
        lab_remove(folder);
        cr_expect_str_eq(manifest.leaderboard ? manifest.leaderboard : "none",
                         cases[i].leaderboard ? cases[i].leaderboard : "none");
        manifest_free(&manifest);
        cr_expect_null(manifest.leaderboard);
    }
}

#define DESK(fields)                                                                               \
    "{\"title\": \"T\", " FILES ", \"tasks\": [" TASK_A ", " TASK_B "], " fields "}"
#define MORE(hints)                                                                                \
    "{\"id\": \"a\", \"file\": \"a.cl\", \"title\": \"A?\", \"points\": {\"a\": 100}, "            \
    "\"hint\": \"h\", \"more_hints\": " hints "}"

Test(manifest, a_lab_may_say_what_the_desk_shows)
{
    char folder[64];
    Manifest manifest;
    lab_write(DESK("\"hours\": 2, \"look\": \"--size 8x8\", \"figure\": \"a.png\""), folder);
    cr_assert_eq(manifest_load(folder, "01-x", &manifest), 0);
    lab_remove(folder);
    cr_expect_eq(manifest.hours, 2);
    cr_expect_str_eq(manifest.look, "--size 8x8");
    cr_expect_str_eq(manifest.figure, "a.png");
    cr_expect_null(manifest.tasks[0].more_hints[0]);
    manifest_free(&manifest);
    lab_write(MANIFEST(FILES, MORE("[\"where\", \"draw\", \"formula\"]")), folder);
    cr_assert_eq(manifest_load(folder, "01-x", &manifest), 0);
    lab_remove(folder);
    cr_expect_str_eq(manifest.tasks[0].more_hints[2], "formula");
    manifest_free(&manifest);
}

typedef struct BadManifest {
    const char *text;
    const char *message;  // part of the one line
} BadManifest;

#define POINTS(points)                                                                             \
    "{\"id\": \"a\", \"file\": \"a.cl\", \"title\": \"C\", \"points\": " points "}"

static const BadManifest bad_manifests[] = {
    {NULL, "lab.json: cannot read: No such file"},
    {"", "lab.json:1: "},
    {"{\n\"title\": T}", "lab.json:2: "},
    {"[]", "lab.json: found a list, expected an object"},
    {"{" FILES ", \"tasks\": [" TASK_A ", " TASK_B "]}", "title: found nothing, expected a string"},
    {"{\"title\": 1, " FILES "}", "title: found a number, expected a string"},
    {"{\"title\": \"\", " FILES "}", "title: found an empty string"},
    {"{\"title\": \"T\", \"title\": \"U\"}", "duplicate object key"},
    {"{\"title\": \"T\", \"weight\": 2}", "found an unknown field \"weight\""},
    {MANIFEST("\"files\": \"a.cl\"", TASK_A), "files: found a string, expected a list"},
    {MANIFEST("\"files\": []", TASK_A), "files: found 0 entries, expected 1 to 8"},
    {MANIFEST("\"files\": [\"1\",\"2\",\"3\",\"4\",\"5\",\"6\",\"7\",\"8\",\"9\"]", TASK_A),
     "files: found 9 entries, expected 1 to 8"},
    {MANIFEST("\"files\": [\"a.cl\", 7]", TASK_A), "files[1]: found a number, expected a string"},
    {MANIFEST("\"files\": [\"../a.cl\"]", TASK_A), "files[0]: found \"../a.cl\", expected a plain"},
    {MANIFEST("\"files\": [\"/etc/passwd\"]", TASK_A), "files[0]: found \"/etc/passwd\", expected"},
    {MANIFEST("\"files\": [\".bashrc\"]", TASK_A), "files[0]: found \".bashrc\", expected a plain"},
    {MANIFEST("\"files\": [\"a.cl\\u0000\"]", TASK_A), "\\u0000"},
    {MANIFEST("\"files\": [\"a.cl\", \"a.cl\"]", TASK_A), "files[1]: found \"a.cl\" a second time"},
    {MANIFEST(FILES, ""), "tasks: found 0 entries, expected 1 to 6"},
    {MANIFEST(FILES, "5"), "tasks[0]: found a number, expected an object"},
    {MANIFEST(FILES, TASK_A ", " TASK_A), "tasks[1]: found the id \"a\" a second time"},
    {MANIFEST(FILES, TASK_A), "tasks: found 40 points in all, expected 100"},
    {MANIFEST(FILES, TASK_B ", "
                            "{\"id\": \"a: b\"}"),
     "tasks[1]: found the id \"a: b\", expected"},
    {MANIFEST(FILES, "{\"id\": \"a\", \"file\": \"c.cl\", \"title\": \"C\", "
                     "\"points\": {\"c\": 100}, \"hint\": \"h\"}"),
     "tasks[0]: found the file \"c.cl\", expected one of \"files\""},
    {MANIFEST(FILES, POINTS("100")),
     "tasks[0].points: found a number, expected an object: the points of each check"},
    {MANIFEST(FILES, POINTS("{}")), "tasks[0].points: found 0 entries, expected 1 to 8"},
    {MANIFEST(FILES, POINTS("{\"1\":1,\"2\":1,\"3\":1,\"4\":1,\"5\":1,\"6\":1,\"7\":1,\"8\":1,"
                            "\"9\":92}")),
     "tasks[0].points: found 9 entries, expected 1 to 8"},
    {MANIFEST(FILES, POINTS("{\"a-far\": 99.5}")),
     "tasks[0].points.a-far: found a fraction, expected a whole number"},
    {MANIFEST(FILES, POINTS("{\"a-far\": \"100\"}")),
     "tasks[0].points.a-far: found a string, expected a whole number"},
    {MANIFEST(FILES, POINTS("{\"a-far\": 100, \"a-near\": 0}")),
     "tasks[0].points.a-near: found 0, expected 1 to 100"},
    {MANIFEST(FILES, POINTS("{\"a-far\": 101}")),
     "tasks[0].points.a-far: found 101, expected 1 to"},
    {MANIFEST(FILES, POINTS("{\"a\": 40, \"a\": 60}")), "duplicate object key"},
    {MANIFEST(FILES, POINTS("{\"a\": 100}")), "tasks[0].hint: found nothing, expected a string"},
    {MANIFEST(FILES, "{\"id\": \"a\", \"tips\": \"h\"}"),
     "tasks[0]: found an unknown field \"tips\""},
    {MANIFEST(FILES, HINTS("\"h\"")), "tasks[0].hints: found a string, expected an object"},
    {MANIFEST(FILES, HINTS("{\"a-far\": 1}")),
     "tasks[0].hints.a-far: found a number, expected a string"},
    {MANIFEST(FILES, HINTS("{\"a-far\": \"h\", \"a-near\": \"\"}")),
     "tasks[0].hints.a-near: found an empty string, expected some text"},
    {MANIFEST(FILES, HINTS("{\"a-fra\": \"h\"}")),
     "tasks[0].hints: found the check \"a-fra\", expected one of \"points\""},
    {MANIFEST(FILES, MORE("\"h\"")), "tasks[0].more_hints: found a string, expected a list"},
    {MANIFEST(FILES, MORE("[\"h\"]")), "tasks[0].more_hints: found 1 entries, expected 3"},
    {MANIFEST(FILES, MORE("[\"h\", 1, \"h\"]")),
     "tasks[0].more_hints[1]: found a number, expected a string"},
    {DESK("\"hours\": 41"), "hours: found 41, expected 1 to 40"},
    {DESK("\"look\": 1"), "look: found a number, expected a string"},
    {DESK("\"figure\": \"a.png\""), "figure: found one without \"look\", expected"},
    {BOARD(FILES, "true"), "leaderboard: found true, expected a string"},
    {BOARD(FILES, "\"\""), "leaderboard: found an empty string, expected some text"},
    {BOARD("\"files\": [\"a.cl\", \"b.cl\", \"c.c\"]", "\"x\""),
     "leaderboard: found one in a lab with host files, expected kernels only"},
};

Test(manifest, names_each_slip_in_one_message, .init = cr_redirect_stderr)
{
    for (size_t i = 0; i < sizeof bad_manifests / sizeof bad_manifests[0]; i++) {
        const BadManifest *bad = &bad_manifests[i];
        char folder[64];
        lab_write(bad->text, folder);
        Manifest manifest;
        int loaded = manifest_load(folder, "01-x", &manifest);
        lab_remove(folder);

        char message[4096];
        stderr_read(message, sizeof message);
        const char *newline = strchr(message, '\n');
        cr_expect_eq(loaded, -1, "manifest %zu was read", i);
        cr_expect_null(manifest.title, "manifest %zu left something behind", i);
        cr_expect(strstr(message, bad->message) != NULL,
                  "manifest %zu: found \"%s\", expected \"%s\"", i, message, bad->message);
        cr_expect(newline != NULL && newline[1] == '\0', "manifest %zu: not one line: %s", i,
                  message);
        cr_expect(strncmp(message, folder, strlen(folder)) == 0, "manifest %zu: no path: %s", i,
                  message);
    }
}

Test(manifest, refuses_what_is_no_lab_name, .init = cr_redirect_stderr)
{
    static const char *const names[] = {
        "", "..", "a/b", ".hidden",
        "a-name-that-is-far-too-long-for-a-lab-and-would-be-cut-off-in-silence-otherwise"};
    for (size_t i = 0; i < sizeof names / sizeof names[0]; i++) {
        Manifest manifest;
        cr_expect_eq(manifest_load("/tmp", names[i], &manifest), -1, "\"%s\" was taken", names[i]);
    }
}
