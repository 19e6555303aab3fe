// Looking into an entry, within limits (see entry_content.h).
#include "entry_content.h"

#include "export_read.h"
#include "message.h"

#include <dirent.h>
#include <fcntl.h>
#include <nettle/sha2.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/random.h>
#include <sys/stat.h>
#include <unistd.h>

// A file, a folder, or what else there is.
typedef struct Piece {
    char *path;  // in the entry; owned
    struct stat status;
} Piece;

typedef struct Look {
    Piece *all;
    int n;
    size_t n_name_bytes;
    int is_over;     // there is more than the limits allow
    int has_failed;  // no memory
} Look;

// ---- What there is ------------------------------------------------------------------------------

// Takes the path over.
static void piece_add(Look *look, char *path, const struct stat *status)
{
    Piece *more = array_grown(look->all, look->n, sizeof *more);
    if (more != NULL) {
        look->all = more;
    }
    look->has_failed |= more == NULL;
    look->has_failed |= path == NULL;
    if (look->has_failed) {
        free(path);
        return;
    }
    look->all[look->n++] = (Piece){path, *status};
    look->n_name_bytes += strlen(path) + 1;
}

static void folder_look(Look *look, int folder, const char *path, int depth);

static void entry_look(Look *look, int parent, const char *path, const char *name, int depth)
{
    struct stat status;
    if (fstatat(parent, name, &status, AT_SYMLINK_NOFOLLOW) != 0) {
        return;
    }
    char target[256] = "";
    if (S_ISLNK(status.st_mode) && readlinkat(parent, name, target, sizeof target - 1) < 0) {
        target[0] = '\0';
    }
    char *own = message_new("%s%s%s%s%s", path, path[0] != '\0' ? "/" : "", name,
                            S_ISLNK(status.st_mode) ? " -> " : "", target);
    piece_add(look, own, &status);
    if (S_ISDIR(status.st_mode) && !look->has_failed) {
        const int folder = openat(parent, name, O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
        if (folder >= 0) {
            folder_look(look, folder, own, depth + 1);
        }
    }
}

// Takes the descriptor over.
static void folder_look(Look *look, int folder, const char *path, int depth)
{
    DIR *entries = depth <= CONTENT_MOST_DEPTH ? fdopendir(folder) : NULL;
    if (entries == NULL) {
        look->is_over |= depth > CONTENT_MOST_DEPTH;
        close(folder);
        return;
    }
    const struct dirent *entry;
    while (!look->has_failed && (entry = readdir(entries)) != NULL) {
        if (strcmp(entry->d_name, ".") == 0 || strcmp(entry->d_name, "..") == 0) {
            continue;
        }
        if (look->n == CONTENT_MOST_FILES || look->n_name_bytes > CONTENT_MOST_NAMES_MB << 20) {
            look->is_over = 1;
            break;
        }
        entry_look(look, folder, path, entry->d_name, depth);
    }
    closedir(entries);
}

// ---- Its bytes ----------------------------------------------------------------------------------

static int paths_compare(const void *left, const void *right)
{
    const Piece *a = left, *b = right;
    return strcmp(a->path, b->path);
}

// The smallest first: what is graded is small.
static int sizes_compare(const void *left, const void *right)
{
    const Piece *a = left, *b = right;
    const int order =
        (a->status.st_size > b->status.st_size) - (a->status.st_size < b->status.st_size);
    return order != 0 ? order : paths_compare(left, right);
}

static int is_read(const Piece *piece)
{
    return S_ISREG(piece->status.st_mode) && piece->status.st_size <= (off_t)CONTENT_MOST_FILE_MB
                                                                          << 20;
}

// Do the files have more bytes than are read?
static int has_more(const Look *look)
{
    off_t n_bytes = 0;
    for (int i = 0; i < look->n; i++) {
        n_bytes += is_read(&look->all[i]) ? look->all[i].status.st_size : 0;
    }
    return n_bytes > (off_t)CONTENT_MOST_MB << 20;
}

static void names_hash(const Look *look, struct sha256_ctx *hash)
{
    for (int i = 0; i < look->n; i++) {
        const struct stat *status = &look->all[i].status;
        char *line = message_new("%s %o %lld", look->all[i].path, status->st_mode & S_IFMT,
                                 S_ISDIR(status->st_mode) ? 0LL : (long long)status->st_size);
        sha256_update(hash, strlen(line) + 1, (const uint8_t *)line);
        free(line);
    }
}

// Hash an open file, of at most *n_left bytes. Takes the descriptor over.
static void file_hash(int file, off_t *n_left, struct sha256_ctx *hash)
{
    uint8_t block[1 << 16];
    ssize_t n;
    while (*n_left > 0 && (n = read(file, block, sizeof block)) > 0) {
        sha256_update(hash, (size_t)n, block);
        *n_left -= n;
    }
    close(file);
}

static void files_hash(const Look *look, const char *path, struct sha256_ctx *hash)
{
    const int entry = open(path, O_RDONLY | O_NONBLOCK | O_CLOEXEC);
    off_t n_left = (off_t)CONTENT_MOST_MB << 20;
    for (int i = 0; i < look->n && entry >= 0 && n_left > 0; i++) {
        const Piece *piece = &look->all[i];
        const int is_whole = piece->path[0] == '\0';  // the entry is this file
        const int file =
            !is_read(piece) ? -1
            : is_whole      ? dup(entry)
                       : openat(entry, piece->path, O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
        if (file >= 0) {
            file_hash(file, &n_left, hash);
        }
    }
    if (entry >= 0) {
        close(entry);
    }
}

// ---- All ----------------------------------------------------------------------------------------

static void all_look(Look *look, const char *path)
{
    struct stat status;
    if (stat(path, &status) != 0) {
        return;
    }
    if (!S_ISDIR(status.st_mode)) {
        piece_add(look, strdup(""), &status);
        return;
    }
    const int folder = open(path, O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (folder >= 0) {
        folder_look(look, folder, "", 0);
    }
}

int entry_content(const char *path, char hex[CONTENT_HEX])
{
    Look look = {0};
    struct sha256_ctx hash;
    uint8_t digest[SHA256_DIGEST_SIZE];
    sha256_init(&hash);
    all_look(&look, path);
    look.is_over |= has_more(&look);
    if (look.n > 0) {
        qsort(look.all, (size_t)look.n, sizeof *look.all, paths_compare);
        names_hash(&look, &hash);
        qsort(look.all, (size_t)look.n, sizeof *look.all, sizes_compare);
        files_hash(&look, path, &hash);
    }
    if (look.is_over) {
        uint8_t other[SHA256_DIGEST_SIZE] = {0};
        look.has_failed |= getrandom(other, sizeof other, 0) != (ssize_t)sizeof other;
        sha256_update(&hash, sizeof other, other);
    }
    sha256_digest(&hash, sizeof digest, digest);
    for (int i = 0; i < SHA256_DIGEST_SIZE; i++) {
        snprintf(hex + 2 * i, 3, "%02x", digest[i]);
    }
    for (int i = 0; i < look.n; i++) {
        free(look.all[i].path);
    }
    free(look.all);
    return look.has_failed ? -1 : look.is_over;
}
