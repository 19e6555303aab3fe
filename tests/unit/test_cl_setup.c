// common/cl_setup, cl_build, build_log and cl_check: devices, programs and readable build errors.
#include "build_log.h"
#include "cl_setup.h"
#include "surroundings.h"

#include <dlfcn.h>
#include <sys/wait.h>

// The driver's cache goes into the test's own folder: a cached program would have no warnings.
static void enter(void)
{
    folder_enter();
    setenv("POCL_CACHE_DIR", surroundings_folder, 1);
    unsetenv(CL_DEVICE_VARIABLE);
}

TestSuite(cl_setup, .init = enter, .fini = folder_leave);

static ClSetup setup_open(void)
{
    ClSetup setup;
    cr_assert_eq(cl_setup_open(NULL, &setup), 0);
    return setup;
}

// ---- Devices ------------------------------------------------------------------------------------

Test(cl_setup, opens_the_first_device_and_closes_it)
{
    ClSetup setup = setup_open();
    cr_expect(setup.context != NULL && setup.queue != NULL && setup.device_name[0] != '\0');
    size_t max_width = 0, max_height = 0;
    cl_setup_image_limit(&setup, &max_width, &max_height);
    cr_expect(max_width >= 8192 && max_height >= 8192, "less than OpenCL 1.2 demands");
    cl_setup_close(&setup);
    cr_expect_null(setup.context);
    cl_setup_close(&setup);
}

Test(cl_setup, a_device_is_chosen_by_number_or_by_part_of_its_name)
{
    capture_begin(1);
    cr_assert_eq(cl_setup_list(stdout), 0);
    char list[512];
    snprintf(list, sizeof list, "%.511s", capture_end(1));
    cr_assert_eq(strncmp(list, "0  ", 3), 0);

    // Six letters from the middle of the name, in the other case.
    char part[7] = "";
    memcpy(part, list + 5, 6);
    for (int i = 0; i < 6; i++) {
        part[i] = (char)(part[i] >= 'a' && part[i] <= 'z' ? part[i] - 32 : part[i]);
    }
    const char *choices[] = {"0", part};
    for (size_t i = 0; i < sizeof choices / sizeof choices[0]; i++) {
        ClSetup setup;
        cr_expect_eq(cl_setup_open(choices[i], &setup), 0, "\"%s\"", choices[i]);
        cl_setup_close(&setup);
    }
}

Test(cl_setup, a_wrong_device_lists_what_there_is)
{
    static const char *const WRONG[] = {"63", "99999999999999999999", "no such device", "-1", ""};
    for (size_t i = 0; i < sizeof WRONG / sizeof WRONG[0]; i++) {
        ClSetup setup;
        capture_begin(2);
        int result = cl_setup_open(WRONG[i], &setup);
        const char *message = capture_end(2);
        expect_one_message(message, WRONG[i]);
        expect_one_message(message, ": 0 \"");
        cr_expect_eq(result, -1);
        cr_expect_null(setup.context);
    }
}

Test(cl_setup, the_variable_holds_where_no_device_is_given)
{
    setenv(CL_DEVICE_VARIABLE, "no such device", 1);
    ClSetup setup;
    cr_expect_eq(WITH_MESSAGE("no such device", cl_setup_open(NULL, &setup)), -1);
    cr_expect_eq(cl_setup_open("0", &setup), 0, "the argument goes before the variable");
    cl_setup_close(&setup);
}

Test(cl_setup, without_a_driver_the_message_says_what_to_do)
{
    setenv("OCL_ICD_VENDORS", "/nonexistent", 1);
    ClSetup setup;
    capture_begin(2);
    int result = cl_setup_open(NULL, &setup);
    const char *message = capture_end(2);
    expect_one_message(message, "OCL_ICD_VENDORS=/nonexistent; unset it");
    expect_one_message(message, "make doctor");
    cr_expect_eq(result, -1);

    cr_expect_eq(WITH_MESSAGE("unset it", cl_setup_list(stdout)), -1);
}

// Stands before the loader's own: where a test wants it, the device has a name of 300 letters.
static int name_is_long;

cl_int clGetDeviceInfo(cl_device_id device, cl_device_info question, size_t n_bytes, void *answer,
                       size_t *n_answer_bytes)
{
    typedef cl_int GetDeviceInfo(cl_device_id, cl_device_info, size_t, void *, size_t *);
    enum { N_LETTERS = 300 };
    if (!name_is_long || question != CL_DEVICE_NAME) {
        // POSIX has dlsym() return functions as void *; C11 has no cast for that.
        void *symbol = dlsym(RTLD_NEXT, "clGetDeviceInfo");
        GetDeviceInfo *driver;
        memcpy(&driver, &symbol, sizeof driver);
        return driver(device, question, n_bytes, answer, n_answer_bytes);
    }
    if (n_answer_bytes != NULL) {
        *n_answer_bytes = N_LETTERS + 1;
    }
    if (answer != NULL && n_bytes <= N_LETTERS) {
        return CL_INVALID_VALUE;
    }
    if (answer != NULL) {
        memset(answer, 'x', N_LETTERS);
        ((char *)answer)[N_LETTERS] = '\0';
    }
    return CL_SUCCESS;
}

Test(cl_setup, a_long_name_is_cut_off)
{
    name_is_long = 1;
    ClSetup setup;
    cr_assert_eq(cl_setup_open("xxx", &setup), 0, "the list has the name, too");
    cr_expect_eq(strlen(setup.device_name), sizeof setup.device_name - 1);
    cr_expect_eq(strspn(setup.device_name, "x"), sizeof setup.device_name - 1);
    cl_setup_close(&setup);
}

// ---- Programs -----------------------------------------------------------------------------------

#define KERNEL "kernel void fill(global int *d_values) { d_values[0] = "

static cl_program build(const ClSetup *setup, const char *path, const char *text,
                        const char *options)
{
    file_write(path, text, strlen(text));
    return cl_setup_build(setup, path, options);
}

static void expect_part(const char *message, const char *part)
{
    cr_expect_not_null(strstr(message, part), "no \"%s\" in:\n%s", part, message);
}

Test(cl_setup, a_good_program_is_built_in_silence)
{
    ClSetup setup = setup_open();
    capture_begin(2);
    cl_program program = build(&setup, "good.cl", KERNEL "VALUE; }\n", "-DVALUE=3");
    cr_expect_str_empty(capture_end(2));
    cr_assert_not_null(program);
    cl_int error = CL_SUCCESS;
    cl_kernel kernel = clCreateKernel(program, "fill", &error);
    cr_expect_eq(error, CL_SUCCESS);
    clReleaseKernel(kernel);
    clReleaseProgram(program);
    cl_setup_close(&setup);
}

Test(cl_setup, an_error_names_its_place_and_shows_it)
{
    ClSetup setup = setup_open();
    mkdir("lab", 0777);
    capture_begin(2);
    cl_program program = build(&setup, "lab/bad.cl", "// one\n" KERNEL "wrong; }\n", NULL);
    const char *message = capture_end(2);
    cr_expect_null(program);
    expect_part(message,
                "lab/bad.cl:2:56: error: use of undeclared identifier 'wrong'\n" KERNEL "wrong; }\n"
                "                                                       ^\n");
    cr_expect_null(strstr(message, "failed to build"), "the driver's noise");
    cl_setup_close(&setup);
}

Test(cl_setup, an_error_in_a_header_names_the_header)
{
    static const char *const FOLDERS[] = {"plain", "with space", "with \"quote#"};
    ClSetup setup = setup_open();
    for (size_t i = 0; i < sizeof FOLDERS / sizeof FOLDERS[0]; i++) {
        char header[64], program_path[64], expected[128];
        snprintf(header, sizeof header, "%s/inner.h", FOLDERS[i]);
        snprintf(program_path, sizeof program_path, "%s/outer.cl", FOLDERS[i]);
        snprintf(expected, sizeof expected, "%s:2:13: error: ", header);
        mkdir(FOLDERS[i], 0777);
        file_write(header, "// one\nint two() { wrong; }\n", 28);
        capture_begin(2);
        cl_program program =
            build(&setup, program_path, "#include \"inner.h\"\n" KERNEL "1; }\n", NULL);
        const char *message = capture_end(2);
        cr_expect_null(program);
        expect_part(message, expected);
        expect_part(message, "int two() { wrong; }\n            ^\n");
    }
    cl_setup_close(&setup);
}

Test(cl_setup, the_programs_own_folder_is_searched_first)
{
    ClSetup setup = setup_open();
    mkdir("own", 0777);
    mkdir("other", 0777);
    file_write("own/value.h", "#define VALUE 1\n", 16);
    file_write("other/value.h", "#error wrong\n", 13);
    cl_program program =
        build(&setup, "own/k.cl", "#include \"value.h\"\n" KERNEL "VALUE; }\n", "-I other");
    cr_assert_not_null(program);
    clReleaseProgram(program);
    cl_setup_close(&setup);
}

Test(cl_setup, a_missing_function_is_told_with_the_files_name)
{
    ClSetup setup = setup_open();
    capture_begin(2);
    cl_program program =
        build(&setup, "k.cl", "int missing(int);\n" KERNEL "missing(1); }\n", NULL);
    const char *message = capture_end(2);
    cr_expect_null(program);
    expect_part(message, "k.cl: ");
    expect_part(message, "missing");
    cl_setup_close(&setup);
}

Test(cl_setup, warnings_of_a_good_program_are_shown_once)
{
    ClSetup setup = setup_open();
    capture_begin(2);
    cl_program program = build(&setup, "k.cl", "#warning mind this\n" KERNEL "1; }\n", NULL);
    const char *message = capture_end(2);
    cr_assert_not_null(program);
    expect_part(message, "k.cl:1:2: warning: mind this\n#warning mind this\n ^\n");
    const char *first = strstr(message, "k.cl:1:2");
    cr_expect(first != NULL && strstr(first + 1, "k.cl:1:2") == NULL, "told twice");
    clReleaseProgram(program);
    cl_setup_close(&setup);
}

Test(cl_setup, programs_that_cannot_be_read_or_options_that_are_none)
{
    ClSetup setup = setup_open();
    mkdir("folder.cl", 0777);
    static const char *const PATHS[] = {"missing.cl", "nowhere/k.cl", "no where/k.cl", "folder.cl"};
    for (size_t i = 0; i < sizeof PATHS / sizeof PATHS[0]; i++) {
        capture_begin(2);
        cl_program program = cl_setup_build(&setup, PATHS[i], NULL);
        const char *message = capture_end(2);
        expect_one_message(message, PATHS[i]);
        expect_one_message(message, ": cannot be read: ");
        cr_expect_null(program);
    }
    capture_begin(2);
    cl_program program = build(&setup, "k.cl", KERNEL "1; }\n", "-no-such-option");
    expect_part(capture_end(2), "k.cl: ");
    cr_expect_null(program);
    cl_setup_close(&setup);
}

// PoCL asks for its cache when it first looks for devices, and again when it builds.
Test(cl_setup, a_cache_that_cannot_be_written_is_hinted_at)
{
    setenv("POCL_CACHE_DIR", "/dev/null", 1);
    ClSetup setup;
    capture_begin(2);
    int result = cl_setup_open(NULL, &setup);
    cl_program program = result == 0 ? build(&setup, "k.cl", KERNEL "1; }\n", NULL) : NULL;
    const char *message = capture_end(2);
    if (program != NULL) {
        SKIP_TEST("this driver needs no cache");
    }
    expect_part(message, "POCL_CACHE_DIR");
}

// ---- Logs of drivers that are not at hand -------------------------------------------------------

static const char *print_log(const char *log)
{
    capture_begin(1);
    build_log_print(stdout, log, "k.cl", NULL, ".");
    return capture_end(1);
}

Test(cl_setup, a_log_with_carets_is_left_as_it_is)
{
    const char *log = "input.cl:5:2: error: no\n  no such line\n  ^~\n";
    expect_part(print_log(log), log);
}

Test(cl_setup, a_log_of_noise_has_no_message)
{
    capture_begin(1);
    int n_messages = build_log_print(stdout,
                                     "\n2 warnings and 1 error generated.\n"
                                     "Device cpu failed to build the program\n",
                                     "k.cl", NULL, ".");
    cr_expect_str_empty(capture_end(1));
    cr_expect_eq(n_messages, 0);
}

// What PoCL 7 says of vectors is no news for who writes a kernel.
Test(cl_setup, warnings_of_calls_between_processors_are_not_shown)
{
    cr_expect_str_empty(print_log(
        "warning: k.cl:1:1: AVX vector argument of type '__private float16' (vector of 16 'float' "
        "values) without 'avx512f' enabled changes the ABI\n"
        "warning: k.cl:1:1 <Spelling=<scratch space>:20:1>: AVX vector return of type 'int16' "
        "(vector of 16 'int' values) without 'avx512f' enabled changes the ABI\n"
        "2 warnings generated.\n"));
}

// Only a whole line is a summary, and a diagnostic is one whatever it says.
Test(cl_setup, errors_that_speak_of_what_is_generated_are_kept)
{
    cr_expect_str_eq(print_log("error: k.cl:1:1: no code generated.\n1 error generated.\n"),
                     "k.cl:1:1: error: no code generated.\n");
    cr_expect_str_eq(print_log("error: k.cl:1:1: so overriding noinline attribute\n"),
                     "k.cl:1:1: error: so overriding noinline attribute\n");
    cr_expect_str_eq(print_log("ptxas: no code was generated.\n"),
                     "k.cl: ptxas: no code was generated.\n");
    cr_expect_str_eq(print_log("see 2 errors generated. Then more\n"),
                     "k.cl: see 2 errors generated. Then more\n");
    cr_expect_str_empty(print_log("3 warnings generated.\n12 errors generated.\r\n"));
    cr_expect_str_eq(print_log("1 error and 2 kernels generated.\n"),
                     "k.cl: 1 error and 2 kernels generated.\n");
    cr_expect_str_eq(print_log("2 errorss generated.\n"), "k.cl: 2 errorss generated.\n");
}

Test(cl_setup, the_caret_stands_below_tabs_and_letters_of_two_bytes)
{
    file_write("k.cl", "\t\xc3\xa4 x\n", 6);
    expect_part(print_log("error: k.cl:1:5: no x\n"), "\n\t\xc3\xa4 x\n\t  ^\n");
}

Test(cl_setup, a_place_that_is_not_in_the_file_is_told_without_a_line)
{
    file_write("k.cl", "one\n", 4);
    cr_expect_str_eq(print_log("error: k.cl:9:1: no\n"), "k.cl:9:1: error: no\n");
    cr_expect_str_eq(print_log("error: gone.cl:1:1: no\n"), "gone.cl:1:1: error: no\n");
    cr_expect_str_eq(print_log("error: k.cl:1:9: no"), "k.cl:1:9: error: no\none\n   ^\n");
}

// PoCL's functions are macros: what it says names where they stand, and what they are inside.
Test(cl_setup, functions_have_their_own_names_and_the_line_that_calls_them)
{
    file_write("k.cl", "max(0, x)\n", 10);
    cr_expect_str_eq(print_log("error: k.cl:1:1 <Spelling=/usr/share/pocl/renames.h:138:24>: call "
                               "to '_cl_max' is ambiguous\n"),
                     "k.cl:1:1: error: call to 'max' is ambiguous\nmax(0, x)\n^\n"
                     "note: its arguments are of different types: for a float write 0.0f, not 0\n");
    cr_expect_str_eq(print_log("error: k.cl:1:1: no matching function for call to '_cl_max'\n"),
                     "k.cl:1:1: error: no matching function for call to 'max'\nmax(0, x)\n^\n"
                     "note: count its arguments, and look at their types: max() has two, so that "
                     "the largest of three is max(a, max(b, c))\n");
    cr_expect(
        strstr(print_log("error: k.cl:1:1: initializing '__private Circle *__private' with an "
                         "expression of type 'const __global Circle *' changes address space "
                         "of pointer\n"),
               "\nnote: a pointer's type names the memory that it points into: `global` for"));
    cr_expect_str_eq(print_log("error: k.cl:1:1 <Spelling=unfinished\n"),
                     "k.cl: error: k.cl:1:1 <Spelling=unfinished\n");
}

// ---- Errors by name -----------------------------------------------------------------------------

Test(cl_setup, errors_have_names)
{
    cr_expect_str_eq(cl_error_name(-51), "CL_INVALID_ARG_SIZE");
    cr_expect_str_eq(cl_error_name(0), "CL_SUCCESS");
    cr_expect_str_eq(cl_error_name(-1001), "CL_PLATFORM_NOT_FOUND_KHR");
    cr_expect_str_eq(cl_error_name(-9999), "unknown OpenCL error");
}

Test(cl_setup, a_failed_call_ends_the_program_and_says_which)
{
    capture_begin(2);
    pid_t child = fork();
    if (child == 0) {
        CL_CHECK(CL_SUCCESS);
        CL_CHECK(clFinish(NULL));
        _exit(0);
    }
    int status = 0;
    waitpid(child, &status, 0);
    const char *message = capture_end(2);
    expect_one_message(message, "test_cl_setup.c:");
    expect_one_message(message, ": clFinish(NULL): CL_INVALID_COMMAND_QUEUE (-36)");
    cr_expect(WIFEXITED(status) && WEXITSTATUS(status) == EXIT_FAILURE);
}
