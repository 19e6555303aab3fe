// Numbers from text, read to the last character: "12abc", "", " 1", "nan", "0x10" are no numbers.
//
// For everything a user types: CSV fields (scene2d_csv.c), scene arguments (scene_arguments.c),
// options (options.c). The locale plays no part: the decimal sign is a point everywhere.
// Read next: scene2d.h.
#ifndef COMMON_NUMBER_H
#define COMMON_NUMBER_H

#include <stdint.h>

// A limit in a message, as its definition writes it: NUMBER_TEXT(LINE_MAX_LENGTH) is "4096". So the
// message follows the limit. For a macro that is a plain number.
#define NUMBER_TEXT(limit) NUMBER_TEXT_OF(limit)
#define NUMBER_TEXT_OF(digits) #digits

// Read a whole number, decimal, from lowest to highest, both included. Returns 0, or -1 and leaves
// *value alone; prints nothing.
int number_read_integer(const char *text, int64_t lowest, int64_t highest, int64_t *value);

// The same for whole numbers up to 2^64 - 1: seeds.
int number_read_unsigned(const char *text, uint64_t lowest, uint64_t highest, uint64_t *value);

// Read a finite number, rounded to the nearest float. Returns 0, or -1 and leaves *value alone;
// prints nothing.
int number_read_float(const char *text, float *value);

#endif
