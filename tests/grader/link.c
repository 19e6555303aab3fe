// Relative links between the pages of a grading (see link.h).
//
// Flow: results of many submissions -> ONE PAGE. Used by class_report.c.
#include "link.h"

#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

// The absolute path of the folder that a file is in or will be in: no links, no "..", no last
// slash.
static int folder_resolve(const char *path, char *folder)
{
    char parent[PATH_MAX];
    const char *slash = strrchr(path, '/');
    size_t length = slash == NULL ? 0 : (size_t)(slash - path) + 1;
    if (length >= sizeof parent) {
        return -1;
    }
    memcpy(parent, path, length);
    parent[length] = '\0';
    return realpath(length > 0 ? parent : ".", folder) != NULL ? 0 : -1;
}

// A path as part of a URL: what is not plainly a name is written as its number.
static void url_write(FILE *link, const char *path)
{
    static const char plain[] =
        "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-._/";
    for (; *path != '\0'; path++) {
        if (strchr(plain, *path) != NULL) {
            fputc(*path, link);
        } else {
            fprintf(link, "%%%02X", (unsigned char)*path);
        }
    }
}

// Write the way from one folder to another, both absolute and without a last slash.
static void way_write(FILE *link, const char *from, const char *to)
{
    size_t common = 0;  // ends behind the last slash that both share
    size_t i = 0;
    for (; from[i] != '\0' && from[i] == to[i]; i++) {
        if (from[i] == '/') {
            common = i + 1;
        }
    }
    // Where one ends, the other may end too or go on with a slash: then all of it is shared.
    if ((from[i] == '\0' || from[i] == '/') && (to[i] == '\0' || to[i] == '/')) {
        common = i;
    }
    fputs("./", link);
    const char *up = from + common + (from[common] == '/');
    while (*up != '\0') {
        fputs("../", link);
        up += strcspn(up, "/");
        up += *up == '/';
    }
    const char *down = to + common + (to[common] == '/');
    url_write(link, down);
    if (*down != '\0') {
        fputc('/', link);
    }
}

char *link_beside(const char *page_path, const char *path, const char *name)
{
    char from[PATH_MAX], to[PATH_MAX], target[PATH_MAX + NAME_MAX + 2];
    if (folder_resolve(page_path, from) != 0 || folder_resolve(path, to) != 0) {
        return NULL;
    }
    snprintf(target, sizeof target, "%s/%s", to, name);
    if (access(target, F_OK) != 0) {
        return NULL;
    }
    char *text = NULL;
    size_t n_bytes;
    FILE *link = open_memstream(&text, &n_bytes);
    if (link == NULL) {
        return NULL;
    }
    way_write(link, from, to);
    url_write(link, name);
    if (fclose(link) != 0) {
        free(text);
        return NULL;
    }
    return text;
}
