// Rounds, seeds and keys of a class's entries (see class_keys.h).
#include "class_keys.h"

#include "class_secret.h"
#include "complain.h"
#include "entry_name.h"
#include "output_file.h"
#include "path.h"

#include <inttypes.h>
#include <nettle/sha2.h>
#include <stdlib.h>
#include <string.h>

enum { HASH_DIGITS = 64 };

typedef struct Content {
    char slug[ENTRY_SLUG_BYTES];
    char hash[HASH_DIGITS + 1];
    char round[HASH_DIGITS + 1];  // "" while it has none
    int is_here;                  // or it was in an earlier run only
} Content;
// How sscanf() reads its texts: their sizes less one.
#define SLUG_FORMAT "%63s"
#define HASH_FORMAT "%64s"
_Static_assert(ENTRY_SLUG_BYTES == 64 && HASH_DIGITS == 64, "as in the formats above");

typedef struct Contents {
    Content *list;
    int n, capacity;
} Contents;

static void hash_end(struct sha256_ctx *context, char text[HASH_DIGITS + 1])
{
    uint8_t digest[SHA256_DIGEST_SIZE];
    sha256_digest(context, sizeof digest, digest);
    for (size_t i = 0; i < sizeof digest; i++) {
        snprintf(text + 2 * i, 3, "%02x", digest[i]);
    }
}

static void hash_add(struct sha256_ctx *context, const char *text)
{
    sha256_update(context, strlen(text), (const uint8_t *)text);
}

// ---- Contents -----------------------------------------------------------------------------------

// Returns 0, or -1 after one message.
static int contents_add(Contents *contents, const Content *content)
{
    if (contents->n == contents->capacity) {
        const int capacity = 2 * contents->capacity + 64;
        Content *list = reallocarray(contents->list, (size_t)capacity, sizeof *list);
        if (list == NULL) {
            complain("grade-class: out of memory");
            return -1;
        }
        contents->list = list;
        contents->capacity = capacity;
    }
    contents->list[contents->n++] = *content;
    return 0;
}

// What is here now, without rounds. Returns 0, or -1 after one message.
static int contents_read(FILE *file, Contents *contents)
{
    char line[256];
    int result = 0;
    while (result == 0 && fgets(line, sizeof line, file) != NULL) {
        Content content = {.is_here = 1};
        if (sscanf(line, SLUG_FORMAT " " HASH_FORMAT, content.slug, content.hash) != 2) {
            complain("grade-class: found \"%s\", expected a slug and a hash", line);
            result = -1;
        } else {
            result = contents_add(contents, &content);
        }
    }
    return result;
}

// ---- Rounds -------------------------------------------------------------------------------------

// Give a content the round that it had; keep one that is not here. Returns 0, or -1 after one
// message.
static int round_take(Contents *contents, const Content *old)
{
    for (int i = 0; i < contents->n; i++) {
        Content *content = &contents->list[i];
        if (strcmp(content->slug, old->slug) == 0) {
            if (strcmp(content->hash, old->hash) == 0) {
                strcpy(content->round, old->round);
            }
            return 0;
        }
    }
    return contents_add(contents, old);
}

// What is gone of a record, or damaged, is new: that costs a grading and gives nothing away.
// Returns 0, or -1 after one message.
static int rounds_read(const char *path, Contents *contents)
{
    char line[256];
    int result = 0;
    FILE *file = fopen(path, "re");
    while (result == 0 && file != NULL && fgets(line, sizeof line, file) != NULL) {
        Content old = {.is_here = 0};
        if (sscanf(line, SLUG_FORMAT " " HASH_FORMAT " " HASH_FORMAT, old.slug, old.hash,
                   old.round) == 3 &&
            strlen(old.round) == HASH_DIGITS) {
            result = round_take(contents, &old);
        }
    }
    if (file != NULL) {
        fclose(file);
    }
    return result;
}

// All that has no round yet is in a new one, which is named by what is in it.
static void round_begin(Contents *contents)
{
    char round[HASH_DIGITS + 1];
    struct sha256_ctx hash;
    sha256_init(&hash);
    for (int i = 0; i < contents->n; i++) {
        const Content *content = &contents->list[i];
        if (content->round[0] == '\0') {
            hash_add(&hash, content->slug);
            hash_add(&hash, " ");
            hash_add(&hash, content->hash);
            hash_add(&hash, "\n");
        }
    }
    hash_end(&hash, round);
    for (int i = 0; i < contents->n; i++) {
        if (contents->list[i].round[0] == '\0') {
            strcpy(contents->list[i].round, round);
        }
    }
}

static void rounds_write(const Contents *contents, FILE *file)
{
    for (int i = 0; i < contents->n; i++) {
        const Content *content = &contents->list[i];
        fprintf(file, "%s %s %s\n", content->slug, content->hash, content->round);
    }
}

// ---- Keys ---------------------------------------------------------------------------------------

static void keys_write(const Contents *contents, const ClassSecret *secret, const char *grader,
                       FILE *file)
{
    for (int i = 0; i < contents->n; i++) {
        const Content *content = &contents->list[i];
        char seed[24], key[HASH_DIGITS + 1];
        struct sha256_ctx hash;
        if (!content->is_here) {
            continue;
        }
        snprintf(seed, sizeof seed, "%" PRIu64,
                 class_secret_seed(secret, content->round, content->slug));
        sha256_init(&hash);
        hash_add(&hash, grader);
        hash_add(&hash, seed);
        hash_add(&hash, content->hash);
        hash_end(&hash, key);
        fprintf(file, "%s %s %s\n", content->slug, key, seed);
    }
}

// Returns 0, or -1 after one message.
static int files_write(const char *folder, const Contents *contents, const ClassSecret *secret,
                       const char *grader)
{
    char path[PATH_MAX];
    OutputFile output;
    path_make(path, "%s/rounds", folder);
    if (output_file_open(&output, path) != 0) {
        return -1;
    }
    rounds_write(contents, output.file);
    if (output_file_commit(&output) != 0) {
        return -1;
    }
    path_make(path, "%s/keys", folder);
    if (output_file_open(&output, path) != 0) {
        return -1;
    }
    keys_write(contents, secret, grader, output.file);
    return output_file_commit(&output);
}

int class_keys_make(const char *folder, const uint64_t *number, const char *grader, FILE *contents)
{
    char path[PATH_MAX];
    Contents all = {0};
    ClassSecret secret;
    path_make(path, "%s/rounds", folder);
    int result = class_secret_open(folder, number, &secret);
    if (result == 0 && (result = contents_read(contents, &all)) == 0 &&
        (result = rounds_read(path, &all)) == 0) {
        round_begin(&all);
        result = files_write(folder, &all, &secret, grader);
    }
    free(all.list);
    return result;
}
