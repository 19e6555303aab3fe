// One table of the formats for other systems, and writing the chosen ones (see report_systems.h).
//
// Flow: judging -> result -> REPORTS. Read next: report_junit.c, report_gradescope.c.
#include "report_systems.h"

#include "complain.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

enum { PATH_BYTES = 640 };

typedef struct Format {
    const char *name, *file;
    int (*write)(const char *path, const Manifest *manifest, const Result *result);
    int (*write_fault)(const char *path, const char *lab);  // NULL: no file says it
} Format;

static const Format known[] = {
    {"junit", "junit.xml", report_junit, report_junit_fault},
    {"tap", "results.tap", report_tap, report_tap_fault},
    {"gradescope", "gradescope.json", report_gradescope, NULL},
    {"autolab", "autolab.txt", report_autolab, NULL},
    {"prairielearn", "prairielearn.json", report_prairielearn, report_prairielearn_fault},
    {"github", "github.txt", report_github, NULL},
};

enum { N_FORMATS = sizeof known / sizeof known[0] };

int formats_read(const char *names, FormatSet *formats)
{
    *formats = 0;
    for (const char *name = names;; name++) {
        const size_t length = strcspn(name, ",");
        int i = 0;
        while (i < N_FORMATS &&
               (strlen(known[i].name) != length || strncmp(known[i].name, name, length) != 0)) {
            i++;
        }
        if (i == N_FORMATS) {
            char names[256] = "";
            for (i = 0; i < N_FORMATS; i++) {
                strncat(names, i > 0 ? ", " : "", sizeof names - strlen(names) - 1);
                strncat(names, known[i].name, sizeof names - strlen(names) - 1);
            }
            complain("grade: --format: found \"%.*s\", expected some of %s", (int)length, name,
                     names);
            return -1;
        }
        *formats |= 1u << i;
        name += length;
        if (*name == '\0') {
            return 0;
        }
    }
}

int formats_write(const char *folder, FormatSet formats, const Manifest *manifest,
                  const Result *result)
{
    for (int i = 0; i < N_FORMATS; i++) {
        char path[PATH_BYTES];
        snprintf(path, sizeof path, "%s/%s", folder, known[i].file);
        if ((formats & 1u << i) && known[i].write(path, manifest, result) != 0) {
            return -1;
        }
    }
    return 0;
}

int formats_write_fault(const char *folder, FormatSet formats, const char *lab)
{
    int written = 0;
    for (int i = 0; i < N_FORMATS; i++) {
        char path[PATH_BYTES];
        snprintf(path, sizeof path, "%s/%s", folder, known[i].file);
        if (!(formats & 1u << i)) {
            continue;
        }
        if (known[i].write_fault != NULL) {
            written = known[i].write_fault(path, lab) != 0 ? -1 : written;
        } else if (unlink(path) != 0 && errno != ENOENT) {
            complain("%s: an older result cannot be removed: %s", path, strerror(errno));
            written = -1;
        }
    }
    return written;
}
