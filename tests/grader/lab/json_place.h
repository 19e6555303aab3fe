// Values of a JSON file that somebody wrote by hand, read with messages that say where each stands.
//
// json_unpack_ex() of jansson does not read them: its errors leave out the place, "tasks[2]".
#ifndef GRADER_JSON_PLACE_H
#define GRADER_JSON_PLACE_H

#include <jansson.h>

// A value in the file, with the words for saying where it stands.
typedef struct Place {
    const char *path;    // of the file
    char name[80];       // "tasks[2].points"; "" for the file's one object
    const json_t *json;  // NULL when it is missing
} Place;

// A field of an object, and an item of a list, there or not.
Place place_field(const Place *object, const char *field);
Place place_item(const Place *list, int i);

// One message that begins with the place. Returns -1, as all below do after one.
__attribute__((format(printf, 2, 3))) int place_fault(const Place *place, const char *format, ...);
// "found a list, expected an object".
int place_fault_kind(const Place *place, const char *expected);

// A misspelt optional field would be lost without a word: refuse what is not known.
//   known   NULL-terminated
int place_fields_check(const Place *object, const char *const *known);

// A text that is not empty. It lives as long as the file's object.
int place_text(const Place *place, const char **text);
int place_text_field(const Place *object, const char *field, const char **text);

// A list of 1 to `most` items.
int place_list_length(const Place *list, int most, int *length);

// A whole number from `lowest` to `highest`.
int place_number_field(const Place *object, const char *field, int lowest, int highest,
                       int *number);

#endif
