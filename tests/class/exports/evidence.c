// The table (see evidence.h). Its texts are cells of the one in tests/INSTRUCTORS.md.
#include "evidence.h"

#include <string.h>

const char *writer_words(Writer writer)
{
    static const char *const words[] = {[WRITER_NOBODY] = "–",
                                        [WRITER_STUDENT] = "a student",
                                        [WRITER_SYSTEM] = "the system",
                                        [WRITER_INSTRUCTOR] = "you"};
    return words[writer];
}

static const SystemEvidence evidences[N_SYSTEMS] = {
    [SYSTEM_NONE] = {"a plain name", "the name of the folder or archive", WRITER_STUDENT, "none",
                     WRITER_NOBODY},
    [SYSTEM_MOODLE] = {"Moodle", "the name and the number before `_assignsubmission_`",
                       WRITER_SYSTEM, "the worksheet's column *Last modified (submission)*",
                       WRITER_SYSTEM},
    [SYSTEM_CANVAS] = {"Canvas", "the name and the number before the name of each file",
                       WRITER_SYSTEM, "no time, only the mark `LATE`", WRITER_SYSTEM},
    [SYSTEM_BLACKBOARD] = {"Blackboard", "the login before `_attempt_`", WRITER_SYSTEM,
                           "the names of the files", WRITER_SYSTEM},
    [SYSTEM_BRIGHTSPACE] = {"Brightspace", "the number and the name before the name of each file",
                            WRITER_SYSTEM, "the names of the files", WRITER_SYSTEM},
    [SYSTEM_ILIAS] = {"ILIAS", "the name of the student's folder", WRITER_SYSTEM,
                      "the time before the name of each file; newer releases write only a mark",
                      WRITER_SYSTEM},
    [SYSTEM_VPL] = {"VPL", "the name of the student's folder", WRITER_SYSTEM, "none",
                    WRITER_NOBODY},
    [SYSTEM_STUDIP] = {"Stud.IP", "`archive_filelist.csv` above the folder of the files",
                       WRITER_SYSTEM, "`archive_filelist.csv` above the folder of the files",
                       WRITER_SYSTEM},
    [SYSTEM_GRADESCOPE] = {"Gradescope", "`submission_metadata.yml` beside folders `submission_N`",
                           WRITER_SYSTEM, "`submission_metadata.yml`", WRITER_SYSTEM},
    [SYSTEM_GIT] = {"Git", "the name of the clone's folder", WRITER_INSTRUCTOR,
                    "the commit that is checked out", WRITER_STUDENT},
    [SYSTEM_OWN] = {"your own", "`WHO=`", WRITER_INSTRUCTOR,
                    "the column `handed in` of your `LIST=` or `WHO=`", WRITER_INSTRUCTOR},
};

const SystemEvidence *evidence_of(ExportSystem system)
{
    return &evidences[system];
}

ExportSystem evidence_find(const char *title)
{
    ExportSystem system = N_SYSTEMS - 1;
    while (system > SYSTEM_NONE && strcmp(title, evidences[system].title) != 0) {
        system--;
    }
    return system;
}
