// What of the host's own files a sandboxed command may read, whichever sandbox it is in.
#ifndef GRADER_SANDBOX_SYSTEM_H
#define GRADER_SANDBOX_SYSTEM_H

#include <glob.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

// Programs and libraries besides /usr: links into it on today's Debian, folders on older systems.
static const char *const system_folders[] = {"/bin",   "/sbin",  "/lib",
                                             "/lib32", "/lib64", "/libx32"};

// Of /etc and /sys only what compilers and OpenCL's drivers need.
static const char *const system_settings[] = {
    "/etc/OpenCL",         // which drivers there are
    "/etc/ld.so.cache",    // where libraries are
    "/etc/alternatives",   // what "cc" stands for
    "/sys/devices/system"  // PoCL asks it for processors and memory
};

// Graphics cards, where there are any: their drivers talk to these device files.
static const char *const system_devices[] = {"/dev/nvidia*", "/dev/dri", "/dev/kfd"};

// Where the loader of OpenCL's drivers shall look instead of /etc/OpenCL/vendors. It goes on inside
// where that is a place which is seen there.
#define VENDORS_VARIABLE "OCL_ICD_VENDORS"

#define SYSTEM_COUNT(list) (sizeof(list) / sizeof *(list))

// Is one of system_devices there?
static inline int has_graphics_card(void)
{
    int n_found = 0;
    for (size_t i = 0; i < SYSTEM_COUNT(system_devices); i++) {
        glob_t found = {0};
        n_found += glob(system_devices[i], GLOB_NOSORT, NULL, &found) == 0;
        globfree(&found);
    }
    return n_found > 0;
}

// The value of VENDORS_VARIABLE where its place is seen inside, else NULL.
static inline const char *visible_vendors(void)
{
    const char *given = getenv(VENDORS_VARIABLE);
    char *place = given != NULL ? realpath(given, NULL) : NULL;
    const int is_seen = place != NULL &&
                        (strncmp(place, "/usr/", 5) == 0 || strncmp(place, "/etc/OpenCL", 11) == 0);
    free(place);
    return is_seen ? given : NULL;
}

#endif
