// The list of participants with the grades in it, for the system that wrote it, and nothing else: a
// line or a column more would be a student or an assignment more there.
//
// Read next: upload_csv.c; gradebook_csv.c, whose file has all that we know besides.
#ifndef CLASS_UPLOAD_CSV_H
#define CLASS_UPLOAD_CSV_H

#include "worksheet.h"

// Write the file, where the list has a column of grades. Returns 0, or -1 after one message.
int upload_csv(const Gradebook *gradebook, const char *path, const Worksheet *worksheet);

#endif
