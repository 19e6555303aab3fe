// Staging: the manifest's files, and only those, from a submission into the instructor's own tree.
//
// Here is decided from which of several folders a file is taken. Read next: stage_file.c.
#include "stage.h"

#include "message.h"
#include "place_read.h"
#include "staging.h"

#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static int has_file(const Staging *staging, int source, int file)
{
    const Places *places = &staging->searched[source].places[file];
    return places->n_equal > 0 && places->rank < RANK_TOLD &&
           (staging->unusable >> source & 1) == 0;
}

// Read a file from its best place in a source. Returns as place_text_read() does.
static ssize_t source_read(const Staging *staging, int source, int file, unsigned char *bytes,
                           time_t *changed)
{
    const Source *searched = &staging->searched[source];
    *changed = 0;
    return place_text_read(searched->folder, &searched->places[file].equal[0], bytes, changed);
}

// The source to take a file from: the submission's own folder; else the archive that has the
// newest; else, where it is nowhere, the one that has something to tell.
static int source_choose(const Staging *staging, int file)
{
    int best = 0;
    time_t newest = 0, changed = 0;
    for (int i = 0; i < staging->n_sources; i++) {
        if (!has_file(staging, i, file)) {
            const Places *known = &staging->searched[best].places[file];
            best = known->n_equal == 0 && staging->searched[i].places[file].n_equal > 0 ? i : best;
            continue;
        }
        if (staging->sources[i].archive == NULL) {
            return i;
        }
        source_read(staging, i, file, staging->others, &changed);
        if (!has_file(staging, best, file) || changed > newest) {
            best = i;
            newest = changed;
        }
    }
    return best;
}

// The source's name in a message.
static const char *source_name(const Staging *staging, int source, char *shown, size_t n_bytes)
{
    const char *archive = staging->sources[source].archive;
    return archive != NULL ? message_show(archive, shown, n_bytes) : "the folder";
}

// What another source's file is beside the chosen one, in staging->bytes.
typedef enum Likeness { SAME, OLDER, AS_NEW } Likeness;

static Likeness source_compare(const Staging *staging, int file, int other, ssize_t n_bytes,
                               time_t newest)
{
    time_t changed;
    const ssize_t n_others = source_read(staging, other, file, staging->others, &changed);
    if (n_others == n_bytes && n_bytes >= 0 &&
        memcmp(staging->bytes, staging->others, (size_t)n_bytes) == 0) {
        return SAME;
    }
    return changed < newest ? OLDER : AS_NEW;
}

// Compare a file with those of the other sources: likeness[i] is set for each that has one. Returns
// how many have.
static int sources_compare(const Staging *staging, int chosen, int file, Likeness likeness[])
{
    time_t newest;
    const ssize_t n_bytes = source_read(staging, chosen, file, staging->bytes, &newest);
    int n_others = 0;
    for (int i = 0; i < staging->n_sources; i++) {
        if (i != chosen && has_file(staging, i, file)) {
            n_others++;
            likeness[i] = source_compare(staging, file, i, n_bytes, newest);
        }
    }
    return n_others;
}

// Of two archives that are equally new nobody knows which is meant: then both must hold the same.
// Returns 0 or 1.
static int sources_agree(const Staging *staging, int chosen, int file, const char *name)
{
    char shown[2][MESSAGE_SHOWN_BYTES];
    Likeness likeness[STAGE_MAX_SOURCES];
    if (staging->sources[chosen].archive == NULL) {
        return 0;
    }
    sources_compare(staging, chosen, file, likeness);
    for (int i = 0; i < staging->n_sources; i++) {
        if (i != chosen && has_file(staging, i, file) && likeness[i] == AS_NEW) {
            fprintf(
                staging->said,
                "%s: found in %s and, with another content and as new, in %s: hand in only one\n",
                name, source_name(staging, chosen, shown[0], sizeof shown[0]),
                source_name(staging, i, shown[1], sizeof shown[1]));
            return 1;
        }
    }
    return 0;
}

// Say from which source a file was taken, and what others hold.
static void source_say(const Staging *staging, int chosen, int file, const char *name)
{
    static const char *const words[] = {[SAME] = "the same",
                                        [OLDER] = "an older one, which does not count,",
                                        [AS_NEW] = "another one, which does not count,"};
    char shown[MESSAGE_SHOWN_BYTES];
    Likeness likeness[STAGE_MAX_SOURCES];
    const int is_archive = staging->sources[chosen].archive != NULL;
    const int n_others = sources_compare(staging, chosen, file, likeness);
    if (!is_archive && n_others == 0) {
        return;
    }
    fprintf(staging->said, "%s: taken from %s%s", name,
            source_name(staging, chosen, shown, sizeof shown),
            staging->unusable != 0 ? " instead" : "");
    for (int i = 0; i < staging->n_sources; i++) {
        if (i != chosen && has_file(staging, i, file)) {
            const Likeness beside = is_archive || likeness[i] == SAME ? likeness[i] : AS_NEW;
            fprintf(staging->said, "; %s is in %s", words[beside],
                    source_name(staging, i, shown, sizeof shown));
        }
    }
    fputc('\n', staging->said);
}

// Take a file from a source. Returns as file_stage() does.
static int file_stage_from(Staging *staging, const char *name, int file, int chosen)
{
    staging->submission = staging->sources[chosen].folder;
    staging->from = staging->searched[chosen].folder;
    return file_stage(staging, name, &staging->searched[chosen].places[file]);
}

// Take a file from the best source; where it cannot be used, from the next one. Returns as
// file_stage() does.
static int file_stage_from_best(Staging *staging, const char *name, int file)
{
    staging->unusable = 0;
    int chosen = source_choose(staging, file);
    if (!has_file(staging, chosen, file)) {
        return file_stage_from(staging, name, file, chosen);  // to say so
    }
    while (has_file(staging, chosen, file) && sources_agree(staging, chosen, file, name) == 0) {
        const int outcome = file_stage_from(staging, name, file, chosen);
        if (outcome != 1) {
            if (outcome == 0) {
                source_say(staging, chosen, file, name);
            }
            return outcome;
        }
        staging->unusable |= 1U << chosen;
        chosen = source_choose(staging, file);
    }
    return 1;
}

// Is there a file of that name, or of one so like it that there is something to tell?
static int is_somewhere(const Staging *staging, int file)
{
    int i = 0;
    while (i < staging->n_sources && staging->searched[i].places[file].n_equal == 0) {
        i++;
    }
    return i < staging->n_sources;
}

static int files_stage(const Manifest *manifest, Staging *staging)
{
    // All files are looked at, so that a student hears of every fault at once.
    int outcome = 0;
    int n_there = 0;
    for (int i = 0; outcome >= 0 && i < manifest->n_files; i++) {
        const int file_outcome = file_stage_from_best(staging, manifest->files[i], i);
        outcome = file_outcome != 0 ? file_outcome : outcome;
        n_there += is_somewhere(staging, i);
    }
    return outcome == 1 && n_there == 0 ? STAGE_NOTHING : outcome;
}

// Open a folder. Links on the way are the instructor's and followed. Returns a descriptor, or -1
// after one message.
static int folder_open(const char *path)
{
    const int folder = open(path, O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    return folder >= 0 ? folder : machinery_fault(path, "", errno);
}

// Open and search all sources. Returns 0, or -1 after one message.
static int sources_search(const Manifest *manifest, Staging *staging)
{
    for (int i = 0; i < staging->n_sources; i++) {
        Source *source = &staging->searched[i];
        source->folder = folder_open(staging->sources[i].folder);
        if (source->folder < 0) {
            return -1;
        }
        if (places_find(source->folder, manifest->lab, manifest->files, manifest->n_files,
                        source->places) != 0) {
            return machinery_fault(staging->sources[i].folder, "", errno);
        }
    }
    return 0;
}

static void sources_close(const Manifest *manifest, const Staging *staging)
{
    for (int i = 0; staging->searched != NULL && i < staging->n_sources; i++) {
        places_free(staging->searched[i].places, manifest->n_files);
        if (staging->searched[i].folder > 0) {
            close(staging->searched[i].folder);
        }
    }
    free(staging->searched);
}

int stage_submission(const Manifest *manifest, const StageSource sources[], int n_sources,
                     const char *destination, char **message)
{
    Staging staging = {.sources = sources,
                       .n_sources = n_sources,
                       .submission = sources[0].folder,
                       .destination = destination,
                       .from = -1,
                       .to = -1};
    char *said = NULL;
    size_t n_bytes = 0;
    int outcome = -1;

    *message = NULL;
    staging.searched = calloc((size_t)n_sources, sizeof *staging.searched);
    staging.bytes = malloc(STAGE_MAX_FILE_BYTES + 1);
    staging.others = malloc(STAGE_MAX_FILE_BYTES + 1);
    staging.said = open_memstream(&said, &n_bytes);
    if (staging.searched == NULL || staging.bytes == NULL || staging.others == NULL ||
        staging.said == NULL) {
        machinery_fault(staging.submission, "", ENOMEM);
    } else if (sources_search(manifest, &staging) == 0 &&
               (staging.to = folder_open(destination)) >= 0) {
        outcome = files_stage(manifest, &staging);
    }

    if (staging.said != NULL && fclose(staging.said) != 0 && outcome >= 0) {
        outcome = machinery_fault(staging.submission, "", ENOMEM);
    }
    sources_close(manifest, &staging);
    if (staging.to >= 0) {
        close(staging.to);
    }
    free(staging.bytes);
    free(staging.others);
    if (outcome >= 0 && n_bytes > 0) {
        said[n_bytes - 1] = '\0';  // no newline after the last line
        *message = said;
    } else {
        free(said);
    }
    return outcome;
}
