// Reading a folder of submissions: all its entries, and which system named them.
//
// Read next: roster.h, which makes rows of it.
#ifndef CLASS_EXPORT_READ_H
#define CLASS_EXPORT_READ_H

#include "export.h"

// Read a folder of submissions. Where it holds nothing but a folder that is such an export, that is
// read instead, with one line on stderr, as for other files that are passed over. Of several
// exercises side by side the one with the lab's number is read; without one, that is an error.
//   is_unpacked  the folder was unpacked from the archive that was given
//   lab_number   GitHub Classroom's names begin with it, an exercise's folder may have it
// Returns 0, or -1 after one message on stderr. Release with export_free().
int export_read(const char *submissions, int is_unpacked, int lab_number, Export *export);
void export_free(Export *export);

#endif
