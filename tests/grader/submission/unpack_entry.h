// Writing one entry of an archive into a folder; used by unpack.c alone.
#ifndef GRADER_UNPACK_ENTRY_H
#define GRADER_UNPACK_ENTRY_H

struct archive;  // libarchive's
struct archive_entry;

enum { ENTRY_DAMAGED = 1, ENTRY_ENCRYPTED = 2 };

// Write the entry that was just read, as unpack.h says, where its path leads; what cannot be
// written there (its name is too long, or another entry is in its way) is passed over.
//   folder            open
//   parts[n_parts]    the path, cut at its slashes; none of them "" or ".."
//   bytes             room for a file, [STAGE_MAX_FILE_BYTES + 1]
// Returns 0, ENTRY_DAMAGED, ENTRY_ENCRYPTED, or -1 with errno set when the folder is at fault.
int unpack_entry(struct archive *archive, struct archive_entry *entry, int folder,
                 char *const *parts, int n_parts, unsigned char *bytes);

#endif
