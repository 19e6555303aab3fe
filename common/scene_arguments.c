// The arguments in a scene's name (see scene_arguments.h).
//
// Read next: number.h.
#include "scene_arguments.h"

#include "complain.h"
#include "number.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

int scene_report_memory(void)
{
    complain("scene: no memory");
    return -1;
}

int scene_report_unknown(const char *name, const char *list, const char *edge_case(int index))
{
    char names[1024] = "";
    for (int i = 0; edge_case(i) != NULL; i++) {
        strncat(names, ", ", sizeof names - strlen(names) - 1);
        strncat(names, edge_case(i), sizeof names - strlen(names) - 1);
    }
    complain("--scene %s: found no such scene, expected %s%s", name, list, names);
    return -1;
}

static int report(const char *scene_name, const char *argument, const char *expected)
{
    complain("--scene %s: found \"%s\", expected %s", scene_name, argument, expected);
    return -1;
}

static int value_read(const char *text, const SceneArgument *takes)
{
    if (takes->whole.value != NULL) {
        return number_read_integer(text, takes->whole.lowest, takes->whole.highest,
                                   takes->whole.value);
    }
    float value;
    if (number_read_float(text, &value) != 0 || value < takes->real.lowest ||
        value > takes->real.highest) {
        return -1;
    }
    *takes->real.value = value;
    return 0;
}

// Which of the arguments that the scene takes is this "name=value"? Its index, or that of the last
// entry, whose name is NULL.
static int argument_find(const char *argument, const SceneArgument *takes)
{
    int index = 0;
    while (takes[index].name != NULL &&
           strncmp(argument, takes[index].name, strlen(takes[index].name)) != 0) {
        index++;
    }
    return index;
}

// Take in one "name=value".
//   seen   bit i: takes[i] was there; in and out
// Returns what was expected instead, or NULL when all is well.
static const char *argument_read(const char *argument, const SceneArgument *takes,
                                 const char *all_names, unsigned *seen)
{
    const int index = argument_find(argument, takes);
    if (takes[index].name == NULL) {
        return all_names;
    }
    if ((*seen >> index & 1) != 0) {
        return "each argument once";
    }
    *seen |= 1u << index;
    return value_read(argument + strlen(takes[index].name), &takes[index]) == 0
               ? NULL
               : takes[index].expected;
}

// Read "n=100,seed=3"; `list` is cut up.
static int list_read(const char *scene_name, char *list, const SceneArgument *takes,
                     const char *all_names)
{
    unsigned seen = 0;
    for (char *argument = list; argument != NULL;) {
        char *comma = strchr(argument, ',');
        if (comma != NULL) {
            *comma = '\0';
        }
        const char *expected = argument_read(argument, takes, all_names, &seen);
        if (expected != NULL) {
            return report(scene_name, argument, expected);
        }
        argument = comma == NULL ? NULL : comma + 1;
    }
    return 0;
}

int scene_arguments_read(const char *scene_name, const SceneArgument *takes, const char *all_names)
{
    const char *colon = strchr(scene_name, ':');
    if (colon == NULL) {
        return 0;
    }
    char *list = strdup(colon + 1);
    int result =
        list == NULL ? scene_report_memory() : list_read(scene_name, list, takes, all_names);
    free(list);
    return result;
}

int scene_arguments_check_radii(const char *scene_name, float min_radius, float max_radius)
{
    if (min_radius > max_radius) {
        complain("--scene %s: found min=%g above max=%g, expected at most that", scene_name,
                 (double)min_radius, (double)max_radius);
        return -1;
    }
    return 0;
}

int scene_is_called(const char *name, const char *generator)
{
    size_t length = strlen(generator);
    return strncmp(name, generator, length) == 0 && (name[length] == '\0' || name[length] == ':');
}

int scene_name_ends_in(const char *name, const char *ending)
{
    size_t length = strlen(name);
    size_t ending_length = strlen(ending);
    return length > ending_length && strcasecmp(name + length - ending_length, ending) == 0;
}
