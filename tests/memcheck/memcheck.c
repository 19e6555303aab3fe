// memcheck: run a submission with a check of each access to memory, by clang's sanitizers: they see
// what a device passes over in silence, such as indices out of range and values never set.
//
//     memcheck --lab 03 [--submission FOLDER]
//
// The lab's probe does the judge's job in the sandbox, with a little OpenCL of our own
// (tests/native/) that compiles kernels for this processor. What the sanitizers write down is
// reported at the student's own line. It is a diagnosis and earns or costs no points. Exit status:
// 0 nothing found, 1 something, 2 it could not be tried.
#include "clean_text.h"
#include "complain.h"
#include "holes.h"
#include "memcheck_job.h"
#include "memcheck_passes.h"
#include "path.h"
#include "settings.h"
#include "source_words.h"
#include "text_file.h"
#include "untouched.h"
#include "workdir_files.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

enum { EXIT_CLEAN = 0, EXIT_FOUND = 1, EXIT_FAULT = 2 };

#define MAX_JOB_BYTES ((size_t)256 << 20)

// ---- The job -----------------------------------------------------------------------------------

// Make a job of another by `write`. Returns 0, or -1 after one message.
static int job_make(const char *from, const char *to, int (*write)(const Sections *job, FILE *file))
{
    Sections job;
    if (sections_load(from, MAX_JOB_BYTES, &job) != 0) {
        complain("memcheck: %s: the job cannot be read", from);
        return -1;
    }
    FILE *file = fopen(to, "wb");
    int failed = file == NULL || write(&job, file) != 0;
    if (file == NULL || fclose(file) != 0) {
        complain("memcheck: %s: cannot be written: %s", to, strerror(errno));
        failed = 1;
    }
    sections_free(&job);
    return failed ? -1 : 0;
}

// Replace the judge's job by one whose arrays end where they end, and put a small one beside it.
// Returns 0, or -1 after one message.
static int jobs_make(const Session *session)
{
    char path[PATH_MAX], small[PATH_MAX];
    workdir_job_path(&session->workdir, 0, path);
    path_make(small, "%s" MEMCHECK_SMALL_JOB, path);
    return job_make(path, path, memcheck_job_write) != 0 ||
                   job_make(path, small, memcheck_job_write_small) != 0
               ? -1
               : 0;
}

// What runs in the sandbox besides. Returns 0, or -1 after one message.
static int libraries_copy(const Session *session)
{
    static const char *const sanitizers[] = {"address", "memory"};
    char from[PATH_MAX], to[PATH_MAX];
    path_make(to, "%s/lib/kernels.h", session->workdir.tree);
    int result = copy_file("tests/native/kernels.h", to);
    path_make(to, "%s/lib/checked.h", session->workdir.tree);
    result |= copy_file("tests/memcheck/checked.h", to);
    for (int i = 0; i < 2; i++) {
        path_make(from, "%s/memcheck/%s.so", session->workdir.build, sanitizers[i]);
        path_make(to, "%s/lib/memcheck-%s.so", session->workdir.tree, sanitizers[i]);
        result |= copy_file(from, to);
    }
    return result;
}

// ---- What is handed in -------------------------------------------------------------------------

// The first line of a text that gives lines other numbers, by #line 5 or # 5; 0 for none.
static int renumbering_line(const char *text)
{
    SourceReader reader = source_reader(text);
    SourceWord last = {0}, word = source_next(&reader);
    while (word.kind != SOURCE_END) {
        if (last.begins_directive && word.in_directive &&
            (word.kind == SOURCE_NUMBER || source_is(&word, SOURCE_NAME, "line"))) {
            return word.line;
        }
        last = word;
        word = source_next(&reader);
    }
    return 0;
}

// Does each line have the number by which a finding names it? Returns 0, or -1 after a message.
static int lines_check(const Memcheck *memcheck)
{
    const Manifest *manifest = &memcheck->session.manifest;
    int result = 0;
    for (int i = 0; i < manifest->n_files; i++) {
        char path[PATH_MAX];
        variant_file(&memcheck->whole, manifest->files[i], path);
        char *text = text_file_read(path);
        const int line = text != NULL ? renumbering_line(text) : 0;
        if (line > 0) {
            complain("%s:%d: found #line, which gives lines other numbers: take it out, so that a "
                     "fault can be told at its line",
                     manifest->files[i], line);
        }
        result = text == NULL || line > 0 ? -1 : result;
        free(text);
    }
    return result;
}

// ---- Telling ----------------------------------------------------------------------------------

// Print what is left to say of what was found.
static void end_print(const Memcheck *memcheck)
{
    if (memcheck->has_finding) {
        printf("It stops at the first: others may follow from it. Correct it, then try again. No "
               "points depend on it.\n");
    } else if (!memcheck->has_trouble) {
        const Manifest *manifest = &memcheck->session.manifest;
        printf("%s: nothing found.%s\n", manifest->lab,
               manifest_has_kernels(manifest) ? " Races between work-items are not looked for."
                                              : "");
    }
}

// Say which tasks stand as they were handed out: what is found there is given.
static void untouched_print(const Memcheck *memcheck)
{
    const Manifest *manifest = &memcheck->session.manifest;
    int n_untouched = 0;
    for (int t = 0; t < manifest->n_tasks; t++) {
        const Task *task = &manifest->tasks[t];
        char path[PATH_MAX];
        variant_file(&memcheck->whole, task->file, path);
        char *answer = hole_load(path, task->id);
        if (answer != NULL && answer_is_untouched(manifest, task, answer)) {
            printf("%s%s",
                   n_untouched++ ? ", " : "Not answered yet, as it was handed out: ", task->id);
        }
        free(answer);
    }
    printf("%s", n_untouched ? "\n" : "");
}

// Say what was taken, where there is something to say: to whom it helps, if nothing was.
static void staged_print(const StagedFiles *staged)
{
    char *clean = message_clean(staged->said);
    if (clean[0] != '\0') {
        fprintf(staged->n_taken > 0 ? stdout : stderr, "%s\n", clean);
    }
    free(clean);
}

// ---- All --------------------------------------------------------------------------------------

// Returns an exit status.
static int memcheck_run(Memcheck *memcheck, const Settings *settings)
{
    Session *session = &memcheck->session;
    if (session_open(session, settings) != 0 || jobs_make(session) != 0 ||
        libraries_copy(session) != 0) {
        return EXIT_FAULT;
    }
    StagedFiles staged;
    if (session_stage(session, settings->submission, &memcheck->whole, &staged) != 0) {
        return EXIT_FAULT;
    }
    staged_print(&staged);
    free(staged.said);
    if (staged.n_taken == 0) {
        return EXIT_FAULT;
    }
    if (lines_check(memcheck) != 0) {
        return EXIT_FAULT;
    }
    // The messages of a compiler that students know.
    Variant *variants[] = {&memcheck->whole};
    if (session->workdir.needs_compiler && session_compile(session, variants, 1) != 0) {
        return EXIT_FAULT;
    }
    if (memcheck->whole.build_log != NULL) {
        char *clean = message_clean(memcheck->whole.build_log);
        printf("It does not compile:\n%s\n", clean);
        free(clean);
        return EXIT_FAULT;
    }
    untouched_print(memcheck);
    if (memcheck_passes(memcheck) != 0) {
        return EXIT_FAULT;
    }
    end_print(memcheck);
    return memcheck->has_finding || memcheck->has_trouble ? EXIT_FOUND : EXIT_CLEAN;
}

int main(int argc, char **argv)
{
    Settings settings;
    const int parsed = settings_parse(argc, argv, &settings);
    if (parsed != 0) {
        return parsed > 0 ? EXIT_CLEAN : EXIT_FAULT;
    }
    settings.device = "";  // there is one only
    static Memcheck memcheck;
    const int status = memcheck_run(&memcheck, &settings);
    variant_free(&memcheck.whole);
    session_close(&memcheck.session);
    return status;
}
