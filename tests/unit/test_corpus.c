// Every input that taught the fuzzer something, once more under gcc's sanitizers.
//
// The fuzzer itself needs clang and hours; what it found is kept in tests/fuzz/corpus/ and takes no
// time. A folder's files are for one reader: their first byte says which (see fuzz_scene3d.c).
#include "../fuzz/fuzz_scene3d.c"

#include "surroundings.h"

#include <glob.h>
#include <signal.h>

static void input_run(const char *path)
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
    LLVMFuzzerTestOneInput(input, n_bytes);
    free(input);
}

static void folder_run(const char *pattern, char first_byte)
{
    glob_t files;
    cr_assert_eq(glob(pattern, 0, NULL, &files), 0, "start in the top folder");
    for (size_t i = 0; i < files.gl_pathc; i++) {
        FILE *file = fopen(files.gl_pathv[i], "rb");
        cr_expect_eq(fgetc(file), first_byte, "%s is in the wrong folder", files.gl_pathv[i]);
        fclose(file);
        input_run(files.gl_pathv[i]);
    }
    globfree(&files);
}

Test(corpus, nff)
{
    folder_run("tests/fuzz/corpus/nff/*", 'n');
}

Test(corpus, pdb)
{
    folder_run("tests/fuzz/corpus/pdb/*", 'p');
}

Test(corpus, xyz)
{
    folder_run("tests/fuzz/corpus/xyz/*", 'x');
}

// The properties do not hold by accident: they see what is wrong.
Test(corpus, a_property_that_does_not_hold_stops_the_run, .signal = SIGABRT)
{
    Scene3D scene = {.n_spheres = 1};
    capture_begin(1);
    check_scene(&scene);
}
