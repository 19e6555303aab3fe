// Every input that taught the fuzzer something, once more under gcc's sanitizers.
//
// The fuzzer itself needs clang and hours; what it found is kept in tests/fuzz/corpus/ and takes no
// time. A target fuzz_NAME.c is compiled for this as a function fuzz_NAME().
#include "fuzz.h"
#include "surroundings.h"

#include <glob.h>
#include <signal.h>

typedef int Target(const uint8_t *bytes, size_t n_bytes);
Target fuzz_forms, fuzz_graded, fuzz_manifest, fuzz_scene3d, fuzz_sections, fuzz_source,
    fuzz_unpack;

static void input_run(Target *target, const char *path)
{
    static uint8_t bytes[64 * 1024];
    FILE *file = fopen(path, "rb");
    cr_assert_not_null(file, "%s", path);
    const size_t n_bytes = fread(bytes, 1, sizeof bytes, file);
    fclose(file);
    cr_assert(n_bytes > 0 && n_bytes < sizeof bytes, "%s holds %zu bytes", path, n_bytes);
    // A copy of just its size, so that the sanitizer sees a read behind its end.
    uint8_t *input = malloc(n_bytes);
    memcpy(input, bytes, n_bytes);
    target(input, n_bytes);
    free(input);
}

static void folder_run(Target *target, const char *pattern)
{
    glob_t files;
    cr_assert_eq(glob(pattern, 0, NULL, &files), 0, "%s: start in the top folder", pattern);
    for (size_t i = 0; i < files.gl_pathc; i++) {
        input_run(target, files.gl_pathv[i]);
    }
    globfree(&files);
}

Test(corpus, graded)
{
    folder_run(fuzz_graded, "tests/fuzz/corpus/graded/*");
}

Test(corpus, manifest)
{
    folder_run(fuzz_manifest, "tests/fuzz/corpus/manifest/*");
}

Test(corpus, sections)
{
    folder_run(fuzz_sections, "tests/fuzz/corpus/sections/*");
}

Test(corpus, forms)
{
    folder_run(fuzz_forms, "tests/fuzz/corpus/forms/*");
    folder_run(fuzz_forms, "tests/fuzz/corpus/source/*");
}

Test(corpus, source)
{
    folder_run(fuzz_source, "tests/fuzz/corpus/source/*");
}

Test(corpus, unpack)
{
    folder_run(fuzz_unpack, "tests/fuzz/corpus/unpack/*");
}

// Of the scenes' inputs the first byte chooses the reader; each reader has a folder.
static void scenes_run(const char *pattern, char first_byte)
{
    glob_t files;
    cr_assert_eq(glob(pattern, 0, NULL, &files), 0, "%s: start in the top folder", pattern);
    for (size_t i = 0; i < files.gl_pathc; i++) {
        FILE *file = fopen(files.gl_pathv[i], "rb");
        cr_expect_eq(fgetc(file), first_byte, "%s is in the wrong folder", files.gl_pathv[i]);
        fclose(file);
    }
    globfree(&files);
    folder_run(fuzz_scene3d, pattern);
}

Test(corpus, nff)
{
    scenes_run("tests/fuzz/corpus/scene3d/nff/*", 'n');
}

Test(corpus, pdb)
{
    scenes_run("tests/fuzz/corpus/scene3d/pdb/*", 'p');
}

Test(corpus, xyz)
{
    scenes_run("tests/fuzz/corpus/scene3d/xyz/*", 'x');
}

// The properties do not hold by accident: what does not hold stops the run.
Test(corpus, a_property_that_does_not_hold_stops_the_run, .signal = SIGABRT)
{
    capture_begin(1);
    MUST_HOLD(1 + 1 == 3);
}
