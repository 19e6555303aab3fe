// Whose files are whose in Stud.IP's export: archive_filelist.csv, which it writes beside the
// folder of the files.
//
//   "Name";"Größe";"Vorname";"Nachname";"Downloads";"Datum";"Pfad"
//   "lab00.zip";"2000";"Ada";"Lovelace";"0";"25.11.2026 18:00";"Lab 0/lab00.zip"
#ifndef CLASS_STUDIP_H
#define CLASS_STUDIP_H

#include "export.h"

#define STUDIP_NAMES_FILE "archive_filelist.csv"

// Give the entries that Stud.IP's list names to their owners, and make Stud.IP the export's system.
// A student may hand in a file of this name. So only a list one or two folders above the files
// counts, where no student can put one, and only if it names more than half of the entries.
//
// Single files of one owner, and an archive beside them, are one attempt, of the time of the last.
// Several archives of one name may be those of two people: each is an entry of its own, and whose
// it is is to be decided. What the list gives to two names is nobody's.
//
// A list that cannot be read is told on stderr, and counts for nothing. Returns whether one counts.
int studip_names_read(Export *export);

#endif
