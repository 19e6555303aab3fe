// Files that are no archives, recognised by how they begin (see file_kind.h).
#include "file_kind.h"

#include <ctype.h>
#include <string.h>

static int begins(const unsigned char *bytes, size_t n_bytes, const char *start)
{
    const size_t n_start = strlen(start);
    return n_bytes >= n_start && memcmp(bytes, start, n_start) == 0;
}

// Windows' "Unicode": by its mark, or as every other byte of such a source is NUL.
static int is_utf16(const unsigned char *bytes, size_t n_bytes)
{
    if (begins(bytes, n_bytes, "\xFF\xFE") || begins(bytes, n_bytes, "\xFE\xFF")) {
        return 1;
    }
    return n_bytes >= 4 && (bytes[0] == 0) != (bytes[1] == 0) &&
           (bytes[0] == 0) == (bytes[2] == 0) && (bytes[1] == 0) == (bytes[3] == 0);
}

// Word and its like write zip archives, whose first file tells.
static int is_office(const unsigned char *bytes, size_t n_bytes)
{
    static const char content_types[] = "[Content_Types].xml",
                      type[] = "mimetypeapplication/vnd.oasis";
    enum { NAME_AT = 30 };
    return begins(bytes, n_bytes, "PK\x03\x04") && n_bytes > NAME_AT &&
           (begins(bytes + NAME_AT, n_bytes - NAME_AT, content_types) ||
            begins(bytes + NAME_AT, n_bytes - NAME_AT, type));
}

int file_is_blank(const unsigned char *bytes, size_t n_bytes)
{
    static const char mark[] = "\xEF\xBB\xBF";
    size_t i = begins(bytes, n_bytes, mark) ? strlen(mark) : 0;
    while (i < n_bytes && isspace(bytes[i])) {
        i++;
    }
    return i == n_bytes;
}

FileKind file_kind(const unsigned char *bytes, size_t n_bytes)
{
    static const char damaged[] = " that is damaged or cut off";
    static const char no_tar[] = " that is cut off or no tar archive";
    static const struct {
        const char *start;
        FileKind kind;
    } kinds[] = {
        {"PK\x03\x04", {"a zip archive", damaged, 0}},
        {"PK\x05\x06", {"an empty zip archive", "", 0}},
        {"Rar!", {"a RAR archive", "", 0}},
        {"7z\xBC\xAF", {"a 7-Zip archive", "", 0}},
        {"\x1F\x8B", {"a compressed file (gzip)", no_tar, 0}},
        {"BZh", {"a compressed file (bzip2)", no_tar, 0}},
        {"\xFD"
         "7zXZ",
         {"a compressed file (xz)", no_tar, 0}},
        {"\x28\xB5\x2F\xFD", {"a compressed file (zstd)", "", 0}},
        {"%PDF", {"a PDF document", "", 0}},
        {"{\\rtf", {"an office program's document", "", 0}},
        {"\xD0\xCF\x11\xE0", {"an office program's document", "", 0}},
        {"\x7F"
         "ELF",
         {"a compiled program", "", 0}},
        {"\x89PNG", {"a picture", "", 0}},
        {"\xFF\xD8\xFF", {"a picture", "", 0}},
    };
    if (file_is_blank(bytes, n_bytes)) {
        return (FileKind){"an empty file", "", 1};
    }
    if (is_utf16(bytes, n_bytes)) {
        return (FileKind){"a text in UTF-16", "", 0};
    }
    if (is_office(bytes, n_bytes)) {
        return (FileKind){"an office program's document", "", 0};
    }
    for (size_t i = 0; i < sizeof kinds / sizeof *kinds; i++) {
        if (begins(bytes, n_bytes, kinds[i].start)) {
            return kinds[i].kind;
        }
    }
    return memchr(bytes, '\0', n_bytes) == NULL ? (FileKind){"a single text file", "", 1}
                                                : (FileKind){"a file of unknown kind", "", 0};
}
