// grader/file_names: names that a system changed are taken, names that a student changed are told.
#include "file_names.h"

#include <criterion/criterion.h>

static void expect_all(const char *const names[], const char *wanted, NameMatch match)
{
    for (int i = 0; names[i] != NULL; i++) {
        cr_expect_eq(name_match(names[i], wanted), match, "%s for %s: found %d, expected %d",
                     names[i], wanted, name_match(names[i], wanted), match);
    }
}

Test(file_names, takes_what_a_system_changed)
{
    static const char *const names[] = {"gradient-1.cl",
                                        "gradient-12.cl",
                                        "gradient (1).cl",
                                        "gradient(2).cl",
                                        "20261103102233_77_gradient.cl",
                                        "20261103102233_77_gradient (1).cl",
                                        "Late Submission - gradient.cl",
                                        "Verspaetete Abgabe - gradient (2).cl",
                                        "doejane_12345_678901_gradient.cl",
                                        "doejane_LATE_12345_678901_gradient-1.cl",
                                        "Jane Doe_123456_assignsubmission_file_gradient.cl",
                                        NULL};
    cr_expect_eq(name_match("gradient.cl", "gradient.cl"), NAME_EXACT);
    expect_all(names, "gradient.cl", NAME_CHANGED);
}

Test(file_names, tells_what_a_student_changed)
{
    static const char *const names[] = {"Gradient.cl",
                                        "gradient.CL",
                                        "gradient.cl.txt",
                                        "SURNAME_gradient.cl",
                                        "Late - gradient.cl",
                                        "gradient_final.cl",
                                        "gradient - Kopie.cl",
                                        "gradient-1x.cl",
                                        "gradient.c",
                                        "gradient",
                                        "gradient.txt",
                                        "gradient (x).cl",
                                        "20261103_7_gradient.cl",
                                        "gradient-1234.cl",
                                        "1_2_gradient.cl",
                                        "gradient-.cl",
                                        "gradient.cl.docx",
                                        "2_gradient (1).cl",
                                        "Copy of gradient-1.cl",
                                        NULL};
    expect_all(names, "gradient.cl", NAME_NEAR);
    static const char *const others[] = {"overlaps_N_Nearer_KD.cl", "my overlaps_n_nearer.cl",
                                         NULL};
    expect_all(others, "overlaps_N_Nearer.cl", NAME_NEAR);
}

Test(file_names, counts_uploads)
{
    cr_expect_eq(name_upload_number("gradient-2.cl"), 2);
    cr_expect_eq(name_upload_number("gradient (999).cl"), 999);
    cr_expect_eq(name_upload_number("gradient.cl"), 0);
    // No system counts that far, and the difference of two must fit.
    cr_expect_eq(name_upload_number("gradient-1000.cl"), 0);
    cr_expect_eq(name_upload_number("gradient-99999999999999999999.cl"), 0);
}

Test(file_names, leaves_other_names_alone)
{
    static const char *const names[] = {
        "",           ".cl",          "gradients.cl", "mygradient.cl",
        "gradient.o", "gradient.h",   "gradient.png", "gradien.cl",
        "render.c",   "gradient1.cl", "cl",           "._gradient.cl",
        NULL};
    expect_all(names, "gradient.cl", NAME_OTHER);
    cr_expect_eq(name_match("Makefile-1", "Makefile"), NAME_OTHER);
}
