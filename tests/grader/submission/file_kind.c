// Files that are no archives, recognised by how they begin (see file_kind.h).
#include "file_kind.h"

#include <string.h>

const char *file_kind(const unsigned char *bytes, size_t n_bytes)
{
    static const struct {
        const char *start, *kind;
    } kinds[] = {
        {"PK\x03\x04", "a zip archive that is damaged or cut off"},
        {"Rar!", "a RAR archive"},
        {"7z\xBC\xAF", "a 7-Zip archive"},
        {"\x1F\x8B", "a compressed file (gzip) that is cut off or no tar archive"},
        {"BZh", "a compressed file (bzip2) that is cut off or no tar archive"},
        {"\xFD"
         "7zXZ",
         "a compressed file (xz) that is cut off or no tar archive"},
        {"\x28\xB5\x2F\xFD", "a compressed file (zstd)"},
        {"%PDF", "a PDF document"},
        {"\xD0\xCF\x11\xE0", "an office program's document"},
        {"\x7F"
         "ELF",
         "a compiled program"},
        {"\x89PNG", "a picture"},
        {"\xFF\xD8\xFF", "a picture"},
    };
    for (size_t i = 0; i < sizeof kinds / sizeof *kinds; i++) {
        const size_t n_start = strlen(kinds[i].start);
        if (n_bytes >= n_start && memcmp(bytes, kinds[i].start, n_start) == 0) {
            return kinds[i].kind;
        }
    }
    if (n_bytes == 0) {
        return "an empty file";
    }
    return memchr(bytes, '\0', n_bytes) == NULL ? "a single text file" : "a file of unknown kind";
}
