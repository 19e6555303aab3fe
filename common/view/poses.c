// Paths through a scene (see poses.h).
//
// Read next: view.c, film.c.
#include "poses.h"

#include "complain.h"
#include "line_reader.h"
#include "number.h"
#include "text_file.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>

static void poses_add(Poses *poses, Pose pose)
{
    if (poses->n == poses->n_allocated) {
        const int n_allocated = 2 * poses->n + 256;
        Pose *grown = world_allocate((size_t)n_allocated * sizeof *grown);
        if (poses->n > 0) {
            memcpy(grown, poses->poses, (size_t)poses->n * sizeof *grown);
        }
        free(poses->poses);
        poses->poses = grown;
        poses->n_allocated = n_allocated;
    }
    poses->poses[poses->n++] = pose;
}

void poses_free(Poses *poses)
{
    free(poses->poses);
    *poses = (Poses){0};
}

// Read the line at hand. Returns 0, or -1 after one message.
static int pose_read(LineReader *reader, const WorldKind *kind, Pose *pose)
{
    char *words[POSE_MAX_NUMBERS];
    *pose = (Pose){0};
    const int n_words = line_split(reader->text, words, POSE_MAX_NUMBERS);
    char found[32], expected[96], quoted[LINE_QUOTE_SIZE];
    snprintf(expected, sizeof expected, "%d: %s", kind->n_numbers, kind->pose_line);
    if (n_words != kind->n_numbers) {
        snprintf(found, sizeof found, "%d numbers", n_words);
        line_fault(reader, "", found, expected);
        return -1;
    }
    for (int i = 0; i < n_words; i++) {
        if (number_read_float(words[i], &pose->numbers[i]) != 0) {
            line_fault(reader, "", line_quote(words[i], quoted), "a number");
            return -1;
        }
    }
    return 0;
}

int poses_read(const char *path, const WorldKind *kind, Poses *poses)
{
    *poses = (Poses){0};
    FILE *file = text_file_open(path);
    if (file == NULL) {
        return -1;
    }
    LineReader reader;
    line_reader_begin(&reader, file, path);
    int result = 0;
    while (result == 0 && line_read(&reader)) {
        Pose pose;
        const char first = reader.text[strspn(reader.text, " \t\r")];
        if (first == '#' || first == '\0') {
            continue;
        }
        result = pose_read(&reader, kind, &pose);
        if (result == 0 && poses->n == POSES_MAX) {
            line_fault(&reader, "", "one more pose", "at most " NUMBER_TEXT(POSES_MAX));
            break;
        }
        poses_add(poses, pose);
    }
    fclose(file);
    if (result == 0 && !reader.failed && poses->n == 0) {
        complain("%s: found no pose, expected a line each: %s", path, kind->pose_line);
    }
    if (result == 0 && !reader.failed && poses->n > 0) {
        return 0;
    }
    poses_free(poses);
    return -1;
}

// ---- Writing ------------------------------------------------------------------------------------

static int write_fault(const char *path)
{
    complain("%s: cannot be written: %s", path, strerror(errno));
    return -1;
}

int poses_record_open(const char *path, const WorldKind *kind, PosesRecord *record)
{
    *record = (PosesRecord){.file = fopen(path, "we"), .path = path};
    if (record->file == NULL) {
        return write_fault(path);
    }
    fprintf(record->file, "# a path, 25 poses a second: %s\n", kind->pose_line);
    return fflush(record->file) == 0 ? 0 : write_fault(path);
}

int poses_record_add(PosesRecord *record, const WorldKind *kind, const Pose *pose)
{
    for (int number = 0; number < kind->n_numbers; number++) {
        // Nine digits give every float back.
        fprintf(record->file, "%s%.9g", number > 0 ? " " : "", pose->numbers[number]);
    }
    fputc('\n', record->file);
    record->n++;
    // A line is far shorter than the stream's buffer, so it is written whole.
    return fflush(record->file) == 0 ? 0 : write_fault(record->path);
}

int poses_record_close(PosesRecord *record)
{
    return fclose(record->file) == 0 ? 0 : write_fault(record->path);
}
