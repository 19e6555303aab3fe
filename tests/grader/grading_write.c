// Writing down what was judged: reports, and pictures beside them (see grading.h).
//
// Called by grade.c. Read next: report.h.
#include "complain.h"
#include "grading.h"
#include "output_file.h"
#include "path.h"
#include "report.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

// Make a folder and its parents. Returns 0, or -1 after one message.
static int folders_make(const char *path)
{
    char part[PATH_MAX];
    path_make(part, "%s/", path);
    for (char *slash = strchr(part + 1, '/'); slash != NULL; slash = strchr(slash + 1, '/')) {
        *slash = '\0';
        if (mkdir(part, 0777) != 0 && errno != EEXIST) {
            complain("grade: %s: cannot be made: %s", part, strerror(errno));
            return -1;
        }
        *slash = '/';
    }
    return 0;
}

// The largest of the student's pictures, or the first drawing; NULL where there is none.
static const PictureResult *telling_picture(const Result *result)
{
    const PictureResult *telling = NULL;
    for (int i = 0; i < result->n_pictures; i++) {
        const PictureResult *picture = &result->pictures[i];
        if (picture->svg_own != NULL) {
            return picture;
        }
        const int n_pixels = picture->own.width * picture->own.height;
        if (n_pixels > (telling ? telling->own.width * telling->own.height : 0)) {
            telling = picture;
        }
    }
    return telling;
}

// One picture in a file beside the report, for pages that show many. Returns 0, or -1 after one
// message.
static int write_picture(const Result *result, const char *output)
{
    char png[PATH_MAX], svg[PATH_MAX];
    path_make(png, "%s/picture.png", output);
    path_make(svg, "%s/picture.svg", output);
    unlink(png), unlink(svg);  // of an earlier grading
    const PictureResult *picture = telling_picture(result);
    if (picture == NULL || picture->svg_own == NULL) {
        return picture == NULL ? 0 : image_save(&picture->own, png);
    }
    OutputFile file;
    if (output_file_open(&file, svg) != 0) {
        return -1;
    }
    fputs(picture->svg_own, file.file);
    return output_file_commit(&file);
}

int grading_tell(const Grading *grading, const char *output, ReportTold told)
{
    if (folders_make(output) != 0) {
        return -1;
    }
    // The watch shows on a terminal what it reads through a pipe (bixense.com/clicolors).
    const int colours = isatty(STDOUT_FILENO) || getenv("CLICOLOR_FORCE") != NULL;
    report_text(stdout, &grading->session.manifest, &grading->result, told, colours);
    return 0;
}

int grading_write(const Grading *grading, const char *output)
{
    char path[PATH_MAX];
    const Manifest *manifest = &grading->session.manifest;
    path_make(path, "%s/results.json", output);
    if (report_json(path, manifest, &grading->result) != 0) {
        return -1;
    }
    if (grading->session.settings->has_no_report) {
        return 0;
    }
    path_make(path, "%s/pictures.json", output);
    if (report_pictures_json(path, &grading->result) != 0) {
        return -1;
    }
    path_make(path, "%s/report.html", output);
    if (report_html(path, manifest, &grading->result) != 0 ||
        write_picture(&grading->result, output) != 0 ||
        report_text_end(stdout, manifest, &grading->result, path) != 0) {
        return -1;
    }
    return 0;
}
