// A followed pixel as JSON (see followed.h): one object, with the steps that the text gives, too.
//
//     {"lab", "scene", "width", "height", "pixel": [x, y],
//      "own": {"tests", "nodes", "leaves", "most_waiting", "n_steps",
//              "origin", "direction", "steps"},
//      "reference": the same, or null, "parting": a step's number or null, "rounding_decides"}
//
// Read next: followed_svg.c.
#include "followed.h"

#include "complain.h"
#include "message.h"
#include "output_file.h"

#include <jansson.h>
#include <math.h>

// JSON has no infinity: what is not met is null.
static json_t *number(double value)
{
    return isfinite(value) ? json_real(value) : json_null();
}

static json_t *numbers(const f32 *values, int n)
{
    json_t *array = json_array();
    for (int i = 0; i < n; i++) {
        json_array_append_new(array, number(values[i]));
    }
    return array;
}

static json_t *id_or_null(u32 id)
{
    return id == NO_ID ? json_null() : json_integer(id);
}

// ---- One step -----------------------------------------------------------------------------------

static json_t *waiting_json(const Steps *steps, u32 i)
{
    StepWaiting waiting[TODO_SIZE];
    json_t *array = json_array();
    for (u32 n = followed_waiting(steps, i, waiting); n > 0; n--) {
        const StepWaiting *entry = &waiting[n - 1];
        json_array_append_new(array,
                              json_pack("{s:o, s:o, s:o}", "node", id_or_null(entry->node), "t_min",
                                        number(entry->t_min), "t_max", number(entry->t_max)));
    }
    return array;
}

// A node's cell, or its children and the plane between them.
static void node2d_add(const KdTree2D *tree, u32 id, json_t *json)
{
    if (id >= tree->n_nodes) {
        return;
    }
    const BBox2D box = tree->nodes_BBox[id];
    json_object_set_new(json, "x", json_pack("[ff]", box.minX, box.maxX));
    json_object_set_new(json, "y", json_pack("[ff]", box.minY, box.maxY));
    if (tree->nodes_flag[id] == INNER) {
        const NodeRel node = tree->nodes_Relations[id];
        json_object_set_new(json, "children",
                            json_pack("[ii]", (int)node.lChild, (int)node.rChild));
    }
}

static void node3d_add(const KdTree3D *tree, const Step *step, json_t *json)
{
    static const char *const MET[] = {"near", "far", "both"};
    json_object_set_new(json, "t_min", number(step->t_min));
    json_object_set_new(json, "t_max", number(step->t_max));
    if (step->kind == STEP_LEAF || step->id >= tree->n_nodes) {
        return;
    }
    const KdNode3 node = tree->nodes[step->id];
    const int side = step->side != 0;
    json_object_set_new(json, "axis", json_integer(node.split_axis));
    json_object_set_new(json, "plane", number(node.split_pos));
    json_object_set_new(json, "near", json_integer((int64_t)node.first + side));
    json_object_set_new(json, "far", json_integer((int64_t)node.first + 1 - side));
    json_object_set_new(json, "meets",
                        step->met <= MET_BOTH ? json_string(MET[step->met]) : json_null());
    json_object_set_new(json, "t_split",
                        step->met == MET_BOTH ? number(step->t_split) : json_null());
}

static json_t *step_json(const World *world, const Steps *steps, u32 i)
{
    static const char *const KINDS[] = {"node", "leaf", "test", "end"};
    const Step *step = &steps->steps[i];
    const int is_2d = world->kind == &CIRCLES, is_visit = step->kind <= STEP_LEAF;
    json_t *json = json_pack("{s:s, s:o}", "step", KINDS[step->kind], "id", id_or_null(step->id));
    if (is_visit && is_2d) {
        node2d_add(world->kind->data(world).tree2d, step->id, json);
    } else if (is_visit) {
        node3d_add(world->kind->data(world).tree3d, step, json);
        json_object_set_new(json, "waiting", waiting_json(steps, i));
    } else if (step->kind == STEP_TEST) {
        json_object_set_new(json, "hit", json_boolean(followed_is_hit(world, step)));
        if (!is_2d) {
            json_object_set_new(json, "t", number(step->answer));
        }
    } else if (is_2d) {
        json_object_set_new(json, "colour", numbers(step->element, 4));
    } else {
        json_object_set_new(json, "t", number(step->nearest));
    }
    return json;
}

// ---- All of it ----------------------------------------------------------------------------------

static json_t *steps_json(const World *world, const Steps *steps)
{
    if (steps->n_steps == 0) {
        return json_null();
    }
    json_t *list = json_array();
    for (u32 i = 0; i < steps_kept(steps->n_steps); i++) {
        json_array_append_new(list, step_json(world, steps, i));
    }
    json_t *json = json_pack("{s:I, s:I, s:I, s:I, s:I}", "tests", (json_int_t)steps->n_tests,
                             "nodes", (json_int_t)steps->n_nodes_visited, "leaves",
                             (json_int_t)steps->n_leaves_visited, "most_waiting",
                             (json_int_t)steps->stack_depth, "n_steps", (json_int_t)steps->n_steps);
    if (world->kind != &CIRCLES) {
        json_object_set_new(json, "origin", numbers(steps->origin, 3));
        json_object_set_new(json, "direction", numbers(steps->direction, 3));
    }
    json_object_set_new(json, "steps", list);
    return json;
}

static json_t *followed_json(const Followed *followed)
{
    const World *world = followed->world;
    char scene[4 * MESSAGE_SHOWN_BYTES];
    return json_pack("{s:s, s:s, s:i, s:i, s:[ii], s:o, s:o, s:o, s:b}", "lab", world->lab->name,
                     "scene", message_show(world->lab->options.scene, scene, sizeof scene), "width",
                     world->width, "height", world->height, "pixel", followed->x, followed->y,
                     "own", steps_json(world, &followed->own), "reference",
                     steps_json(world, &followed->reference), "parting",
                     followed->parting < 0 ? json_null() : json_integer(followed->parting),
                     "rounding_decides", followed->is_close);
}

int followed_save_json(const Followed *followed, const char *path)
{
    // Where memory ran out on the way, nothing is left of it.
    json_t *json = followed_json(followed);
    if (json == NULL) {
        complain("%s: no memory", path);
        return -1;
    }
    OutputFile output;
    if (output_file_open(&output, path) != 0) {
        json_decref(json);
        return -1;
    }
    json_dumpf(json, output.file, JSON_INDENT(2) | JSON_REAL_PRECISION(9));
    fprintf(output.file, "\n");
    json_decref(json);
    return output_file_commit(&output);
}
