// Unit tests of the names that course systems give to what students hand in.
#include "course_system.h"
#include "entry_name.h"
#include "ilias.h"
#include "text_file.h"

#include <criterion/criterion.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct Case {
    const char *entry;
    ExportSystem system;
    const char *name, *number, *login, *time, *file;
} Case;

// As the first system whose pattern it is.
static SystemName read_first(const char *entry)
{
    static const ExportSystem order[] = {SYSTEM_BLACKBOARD, SYSTEM_BRIGHTSPACE, SYSTEM_CANVAS,
                                         SYSTEM_ILIAS, SYSTEM_VPL};
    SystemName name = {0};
    for (size_t i = 0; i < sizeof order / sizeof *order && name.system == SYSTEM_NONE; i++) {
        name = system_name_read(entry, order[i]);
    }
    return name;
}

static void expect_part(NamePart part, const char *wanted, const char *entry)
{
    cr_expect(part.length == strlen(wanted) &&
                  (part.length == 0 || memcmp(part.text, wanted, part.length) == 0),
              "%s: found %.*s, expected %s", entry, (int)part.length, part.text, wanted);
}

Test(system_names, are_taken_apart)
{
    static const Case cases[] = {
        {"lovelaceada_40012_880036_file.cl", SYSTEM_CANVAS, "lovelaceada", "40012", "40012", "",
         "file.cl"},
        {"lovelaceada_LATE_40012_880036_a_b-1.cl", SYSTEM_CANVAS, "lovelaceada", "40012", "40012",
         "", "a_b-1.cl"},
        {"d_artagnan_1st_LATE_40012_880036_1 2.cl", SYSTEM_CANVAS, "d_artagnan_1st", "40012",
         "40012", "", "1 2.cl"},
        {"anon_x7Q2b_880036_file.cl", SYSTEM_CANVAS, "anon_x7Q2b", "", "", "", "file.cl"},
        {"LATE_anon_x7Q2b_880036_1_2_3.cl", SYSTEM_CANVAS, "anon_x7Q2b", "", "", "", "1_2_3.cl"},
        {"anon_12345_880036_file.cl", SYSTEM_CANVAS, "anon", "12345", "12345", "", "file.cl"},
        {"anon_x7Q2b_text.html", SYSTEM_CANVAS, "anon_x7Q2b", "", "", "", "text.html"},
        {"group_a_03_40012_file.cl", SYSTEM_NONE, "", "", "", "", ""},
        {"group_a_4001_12_file.cl", SYSTEM_NONE, "", "", "", "", ""},
        {"_LATE_40012_880036_file.cl", SYSTEM_NONE, "", "", "", "", ""},
        {"lovelaceada_40012_text.html", SYSTEM_CANVAS, "lovelaceada", "40012", "40012", "",
         "text.html"},
        {"Lab 0_ab12_attempt_2026-11-03-10-22-33_file.cl", SYSTEM_BLACKBOARD, "ab12", "", "",
         "2026-11-03-10-22-33", "file.cl"},
        {"Lab_0_ab12_attempt_2026-11-03-10-22-33.txt", SYSTEM_BLACKBOARD, "ab12", "", "",
         "2026-11-03-10-22-33", "txt"},
        {"40012-88 - Ada Lovelace - Nov 3, 2026 1022 PM", SYSTEM_BRIGHTSPACE, "Ada Lovelace",
         "40012", "40012", "2026-11-03-22-22", ""},
        {"40012-88 - A B - 3 November, 2026 922 - a - b.cl", SYSTEM_BRIGHTSPACE, "A B", "40012",
         "40012", "2026-11-03-09-22", "a - b.cl"},
        // Which of two dates is Brightspace's, nobody knows, be one in a form of another country.
        {"40012-88 - A B - Nov 3, 2026 922 AM - lab - Nov 1, 2026 922 AM - b.cl",
         SYSTEM_BRIGHTSPACE, "A B", "40012", "40012", "", "lab - Nov 1, 2026 922 AM - b.cl"},
        {"40012-88 - A B - 3. Nov 2026 9.22 - lab - Nov 1, 2026 922 AM - b.cl", SYSTEM_BRIGHTSPACE,
         "A B - 3. Nov 2026 9.22 - lab", "40012", "40012", "", "b.cl"},
        {"40012-88 - A - B - Nov 3, 2026 922 AM", SYSTEM_BRIGHTSPACE, "A - B", "40012", "40012",
         "2026-11-03-09-22", ""},
        {"Lovelace_Ada_ada_1234", SYSTEM_ILIAS, "Lovelace_Ada", "1234", "ada", "", ""},
        {"x_40013_40099_880040_file.cl", SYSTEM_NONE, "", "", "", "", ""},
        // A student may choose such a name, with another one's number.
        {"lovelaceada_40012_880036_x_40013_880037_file.cl", SYSTEM_NONE, "", "", "", "", ""},
        {"lovelaceada_40012_880036_x_LATE_40013_880037_f.cl", SYSTEM_NONE, "", "", "", "", ""},
        {"lovelaceada_40012_880036_x_40013_text.html", SYSTEM_NONE, "", "", "", "", ""},
        {"40012-88 - Ada - Okt 3, 2026 1022 PM", SYSTEM_BRIGHTSPACE, "Ada", "40012", "40012", "",
         ""},
        {"Lovelace Ada 1234 ada", SYSTEM_VPL, "Lovelace Ada", "1234", "ada", "", ""},
        {"von Weiß 2 Anna 3 1234 anna", SYSTEM_VPL, "von Weiß 2 Anna 3", "1234", "anna", "", ""},
        {"Team 2 final", SYSTEM_NONE, "", "", "", "", ""},
        {"ada", SYSTEM_NONE, "", "", "", "", ""},
        {"ada_2", SYSTEM_NONE, "", "", "", "", ""},
        {"Lab 0_attempt_2026-11-03-10-22-33_file.cl", SYSTEM_BLACKBOARD, "Lab 0", "", "",
         "2026-11-03-10-22-33", "file.cl"},
        {"_attempt_2026-11-03-10-22-33_file.cl", SYSTEM_NONE, "", "", "", "", ""},
        {"40012-88 - Ada - file.cl", SYSTEM_NONE, "", "", "", "", ""},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        const SystemName name = read_first(cases[i].entry);
        cr_expect_eq(name.system, cases[i].system, "%s: found %s", cases[i].entry,
                     course_system(name.system)->title);
        expect_part(name.name, cases[i].name, cases[i].entry);
        expect_part(name.number, cases[i].number, cases[i].entry);
        expect_part(name.login, cases[i].login, cases[i].entry);
        expect_part(name.file, cases[i].file, cases[i].entry);
        cr_expect_str_eq(name.time, cases[i].time, "%s: found %s", cases[i].entry, name.time);
    }
}

// What students call their files cannot give them to somebody else.
Test(system_names, a_files_own_name_is_nobody_elses)
{
    static const struct {
        const char *entry, *name;
    } cases[] = {
        {"adal_1_2_x_40013_880_file.cl", ""},
        {"L_ab_attempt_2026-11-03-10-22-33_L_cd_attempt_2026-11-04-10-22-33_f.cl", "ab"},
        {"4-8 - Ada - Nov 3, 2026 1022 PM - Bob - Nov 4, 2026 1022 PM - f.cl", "Ada"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        expect_part(read_first(cases[i].entry).name, cases[i].name, cases[i].entry);
    }
}

Test(system_names, ilias_writes_the_time_before_a_file)
{
    cr_expect_eq(ilias_time_length("20261103102233_17_file.cl"), 18);
    cr_expect_eq(ilias_time_length("20261103102233_17_"), 0);
    cr_expect_eq(ilias_time_length("2026110310223_17_file.cl"), 0);
}

// A folder has no file's name behind the student's, and a file has one.
Test(system_names, of_folders_and_of_files_differ)
{
    cr_expect_eq(
        entry_name_read_export("40012-88 - Ada - Nov 3, 2026 1022 PM", 1, SYSTEM_BRIGHTSPACE)
            .system,
        SYSTEM_BRIGHTSPACE);
    cr_expect_eq(
        entry_name_read_export("40012-88 - Ada - Nov 3, 2026 1022 PM", 0, SYSTEM_BRIGHTSPACE)
            .system,
        SYSTEM_NONE);
    cr_expect_eq(entry_name_read_export("adal_1_2_x.cl", 1, SYSTEM_CANVAS).system, SYSTEM_NONE);
}

// ---- What decides ------------------------------------------------------------------------------

// The table of the code is the one that instructors read, row by row.
Test(evidence, is_the_table_that_instructors_read)
{
    char *text = text_file_read("tests/INSTRUCTORS.md");
    for (ExportSystem system = SYSTEM_NONE; system < N_SYSTEMS; system++) {
        char row[512];
        const CourseSystem *evidence = course_system(system);
        snprintf(row, sizeof row, "\n| %s | %s | %s | %s | %s |\n", evidence->title,
                 evidence->identity, writer_words(evidence->identity_writer), evidence->time,
                 writer_words(evidence->time_writer));
        cr_expect_not_null(strstr(text, row), "tests/INSTRUCTORS.md: expected the row%s", row);
        cr_expect_eq(course_system_find(evidence->title), system);
    }
    cr_expect_eq(course_system_find("Canvas LMS"), SYSTEM_NONE);
    free(text);
}
