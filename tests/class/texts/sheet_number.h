// Numbers as people's spreadsheets and course systems write them.
#ifndef CLASS_SHEET_NUMBER_H
#define CLASS_SHEET_NUMBER_H

// Read "100", "99.5", "99,50", "1,000.00", "1.000,00", "1 000,00" or "1'000.00", wholly: no sign,
// no unit. Of "1,000" nobody can say whether it is a thousand or one: it is none.
//   decimal   the sign before the decimals, '.' where there are none
// Returns 0, or -1 when the text is no such number.
int sheet_number_read(const char *text, double *number, char *decimal);

#endif
