// The arguments in a scene's name: "n=100,seed=3" of "random:n=100,seed=3". They may stand in any
// order, each at most once.
//
// scene2d_generate.c and scene3d_generate.c say in a table what a scene takes; the reading is done
// here.
// Read next: scene2d_generate.c.
#ifndef COMMON_SCENE_ARGUMENTS_H
#define COMMON_SCENE_ARGUMENTS_H

#include <stdint.h>

// One argument that a scene takes: a whole number or a real one. The other kind's value is NULL.
typedef struct SceneArgument {
    const char *name;      // with the sign: "n="
    const char *expected;  // for messages: "n=N, a whole number from 0 to 10000000"
    struct {
        int64_t *value;  // where it goes; keeps what it holds when the user says nothing
        int64_t lowest, highest;
    } whole;
    struct {
        float *value;
        float lowest, highest;
    } real;
} SceneArgument;

// Is `name` the generator's, alone or with arguments: "random", "random:..."? Not "randomly".
int scene_is_called(const char *name, const char *generator);

// Read the arguments after the colon of a scene's name; a name without a colon has none.
//   takes      what the scene takes, at most 32, up to an entry whose name is NULL
//   all_names  what is expected where an argument is none of these: "n=N or seed=S"
// Returns 0, or -1 after one message on stderr.
int scene_arguments_read(const char *scene_name, const SceneArgument *takes, const char *all_names);

// Check that the smallest radius is not above the largest. Returns 0, or -1 after one message.
int scene_arguments_check_radii(const char *scene_name, float min_radius, float max_radius);

// Does a name end like this, with something before it? "circles.csv" in ".csv", not ".csv" itself.
// Capitals count as small letters: other systems call it "CIRCLES.CSV".
int scene_name_ends_in(const char *name, const char *ending);

// Say that there is no scene of this name; `list` and the edge cases are. Returns -1.
//   edge_case   their names; NULL for the index after the last
int scene_report_unknown(const char *name, const char *list, const char *edge_case(int index));

// Say that memory ran out. Returns -1.
int scene_report_memory(void);

#endif
