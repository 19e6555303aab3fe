// The arguments in a scene's name (see scene_arguments.h).
//
// Flow: SCENE -> buffers -> kernel -> image -> comparison. Read next: number.h.
#include "scene_arguments.h"

#include "complain.h"
#include "number.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

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

// Take in one "name=value". Returns what was expected instead, or NULL when all is well.
static const char *argument_read(const char *argument, const SceneArgument *takes,
                                 const char *all_names)
{
    for (; takes->name != NULL; takes++) {
        size_t length = strlen(takes->name);
        if (strncmp(argument, takes->name, length) == 0) {
            return value_read(argument + length, takes) == 0 ? NULL : takes->expected;
        }
    }
    return all_names;
}

// Read "n=100,seed=3"; `list` is cut up.
static int list_read(const char *scene_name, char *list, const SceneArgument *takes,
                     const char *all_names)
{
    for (char *argument = list; argument != NULL;) {
        char *comma = strchr(argument, ',');
        if (comma != NULL) {
            *comma = '\0';
        }
        const char *expected = argument_read(argument, takes, all_names);
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
    return length > ending_length && strcmp(name + length - ending_length, ending) == 0;
}
