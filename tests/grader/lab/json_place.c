// Reading values of a JSON file (see json_place.h).
#include "json_place.h"

#include "complain.h"
#include "message.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

// The longest complaint; what it quotes from the file is shortened to fit.
enum { COMPLAINT_BYTES = 400 };

int place_fault(const Place *place, const char *format, ...)
{
    char complaint[4 * COMPLAINT_BYTES], shown[COMPLAINT_BYTES];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(complaint, sizeof complaint, format, arguments);
    va_end(arguments);
    complain("%s: %s%s%s", place->path, place->name, place->name[0] != '\0' ? ": " : "",
             message_show(complaint, shown, sizeof shown));
    return -1;
}

int place_fault_kind(const Place *place, const char *expected)
{
    static const char *const kinds[] = {
        [JSON_OBJECT] = "an object", [JSON_ARRAY] = "a list",    [JSON_STRING] = "a string",
        [JSON_INTEGER] = "a number", [JSON_REAL] = "a fraction", [JSON_TRUE] = "true",
        [JSON_FALSE] = "false",      [JSON_NULL] = "null",
    };
    const char *found = place->json == NULL ? "nothing" : kinds[json_typeof(place->json)];
    return place_fault(place, "found %s, expected %s", found, expected);
}

Place place_field(const Place *object, const char *field)
{
    Place place = {.path = object->path, .json = json_object_get(object->json, field)};
    snprintf(place.name, sizeof place.name, "%.60s%s%.16s", object->name,
             object->name[0] != '\0' ? "." : "", field);
    return place;
}

Place place_item(const Place *list, int i)
{
    Place place = {.path = list->path, .json = json_array_get(list->json, (size_t)i)};
    snprintf(place.name, sizeof place.name, "%.60s[%d]", list->name, i);
    return place;
}

int place_fields_check(const Place *object, const char *const *known)
{
    if (!json_is_object(object->json)) {
        return place_fault_kind(object, "an object");
    }
    const char *name;
    json_t *value;
    json_object_foreach((json_t *)object->json, name, value)
    {
        int i = 0;
        while (known[i] != NULL && strcmp(known[i], name) != 0) {
            i++;
        }
        if (known[i] == NULL) {
            return place_fault(object, "found an unknown field \"%s\"", name);
        }
    }
    return 0;
}

int place_text(const Place *place, const char **text)
{
    if (!json_is_string(place->json)) {
        return place_fault_kind(place, "a string");
    }
    if (json_string_length(place->json) == 0) {
        return place_fault(place, "found an empty string, expected some text");
    }
    *text = json_string_value(place->json);
    return 0;
}

int place_text_field(const Place *object, const char *field, const char **text)
{
    Place place = place_field(object, field);
    return place_text(&place, text);
}

int place_list_length(const Place *list, int most, int *length)
{
    if (!json_is_array(list->json)) {
        return place_fault_kind(list, "a list");
    }
    size_t found = json_array_size(list->json);
    if (found < 1 || found > (size_t)most) {
        return place_fault(list, "found %zu entries, expected 1 to %d", found, most);
    }
    *length = (int)found;
    return 0;
}

int place_number_field(const Place *object, const char *field, int lowest, int highest, int *number)
{
    Place place = place_field(object, field);
    if (!json_is_integer(place.json)) {
        return place_fault_kind(&place, "a whole number");
    }
    json_int_t found = json_integer_value(place.json);
    if (found < lowest || found > highest) {
        return place_fault(&place, "found %" JSON_INTEGER_FORMAT ", expected %d to %d", found,
                           lowest, highest);
    }
    *number = (int)found;
    return 0;
}
