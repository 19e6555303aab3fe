// common/lab: how a lab's program begins, fails and ends. That it draws and counts is seen in the
// suites "programs" and "programs3d".
#include "lab.h"
#include "surroundings.h"

#include <jansson.h>

static void enter(void)
{
    folder_enter();
    mkdir("kernels", 0777);  // looks like a course
    mkdir("labs", 0777);
}

TestSuite(lab, .init = enter, .fini = folder_leave);

// Begin with a command line of one word, or none where it is NULL.
static Lab begin(const char *word, int set)
{
    char *argv[] = {(char *)"program", (char *)word, NULL};
    return lab_begin(word != NULL ? 2 : 1, argv, "01-naive-2d", "Draws circles.", set);
}

Test(lab, what_is_required_and_there_goes_on)
{
    require(0);
}

Test(lab, what_is_required_and_missing_ends_the_program, .exit_code = EXIT_FAILURE)
{
    require(-1);
}

Test(lab, a_wrong_command_line_ends_the_program, .exit_code = EXIT_FAILURE)
{
    begin("--no-such", 0);
    exit(77);
}

Test(lab, help_ends_the_program_well, .exit_code = EXIT_SUCCESS)
{
    begin("--help", 0);
    exit(77);
}

Test(lab, a_program_that_does_not_build_ends_it, .exit_code = EXIT_FAILURE)
{
    Lab lab = {0};
    lab_build_program(&lab, "no-such.cl", "");
    exit(77);
}

// The names of the figures that a run ends with, one after the other.
static void expect_figures(const Lab *lab, const char *expected)
{
    char names[256] = "";
    const char *name;
    json_t *value;
    json_object_foreach(lab->stats.values, name, value)
    {
        snprintf(names + strlen(names), sizeof names - strlen(names), " %s", name);
    }
    cr_expect_str_eq(names, expected);
}

Test(lab, a_run_is_described_by_what_it_uses)
{
    Lab lab = begin(NULL, OPTIONS_SCENE);
    lab_describe(&lab, "n_circles", 3, 40, 30);
    expect_figures(&lab, " lab scene n_circles width height");
    stats_free(&lab.stats);

    lab = begin(NULL, OPTIONS_DEVICE);
    lab_describe(&lab, NULL, 0, 40, 30);
    expect_figures(&lab, " lab width height");
    stats_free(&lab.stats);

    lab = begin(NULL, OPTIONS_SCENE3D | OPTIONS_DEVICE);
    char device;  // only its being there counts
    lab.cl.device = (cl_device_id)(void *)&device;
    strcpy(lab.cl.device_name, "a device");
    lab_describe(&lab, "n_spheres", 3, 40, 30);
    expect_figures(&lab, " lab device scene n_spheres width height");
    stats_free(&lab.stats);
}

Test(lab, the_end_writes_the_figures)
{
    Lab lab = begin("--stats=figures.json", OPTIONS_SCENE);
    lab_describe(&lab, NULL, 0, 40, 30);
    lab_end(&lab);
    cr_expect_null(lab.stats.values);
    json_t *figures = json_load_file("figures.json", 0, NULL);
    cr_expect_eq(json_integer_value(json_object_get(figures, "width")), 40);
    json_decref(figures);
}

Test(lab, figures_that_cannot_be_written_end_the_program, .exit_code = EXIT_FAILURE)
{
    Lab lab = begin(NULL, OPTIONS_SCENE);
    lab.options.stats = "no-such-folder/figures.json";
    lab_end(&lab);
    exit(77);
}
