// Judge of lab 10: each function on chosen inputs, what rays hit in whole scenes, the pictures, and
// the counted work of tiles. The functions' inputs are rolled and judged in the files that
// judge_10.h names.
//
// Hits are those of brute force, ray by ray, whatever a tile does: only rays that the oracle calls
// ambiguous may differ. So nothing may be left out that a ray meets; that not too much is asked,
// the work says, tile by tile (judge_10_work.c).
#include "judge_10.h"

#include "job_work.h"
#include "message.h"

// ---- Rolling the job ----------------------------------------------------------------------------

static int roll(void *pointer, Random *random)
{
    Job10 *job = pointer;
    roll_planes_10(random, job);
    roll_children_10(random, job);
    roll_waiting_10(random, job);
    roll_cones_10(random, job);
    if (roll_scenes_10(random, job->scenes) != 0) {
        return -1;
    }
    roll_rows_10(random, job);
    if (roll_circles_10(random, job) != 0) {
        return -1;
    }
    add_sent_10(random, job);
    return 0;
}

static int write_scene(const void *job, int k, FILE *file)
{
    return scene_10_write(&((const Job10 *)job)->scenes[k], k, file);
}

// ---- Scenes -------------------------------------------------------------------------------------

static Verdict judge_hits(const void *job, int k, const Sections *answers)
{
    const JobScene3D *scene = &((const Job10 *)job)->scenes[k];
    const HitAnswer *found = hits_find(scene, k, answers);
    return found == NULL ? verdict_missing : verdict_of(hits_judge(scene, found));
}

// Which of the numbers is too large, of all tiles: a sentence where it is one of them alone.
static Cause cause_of_work(int more_nodes, int more_tests)
{
    if (more_nodes || !more_tests) {
        return (Cause){0};
    }
    return (Cause){
        .says = "the right leaves are visited, but spheres are asked there that the whole tile "
                "misses"};
}

// Do a scene's tiles more than they may?
static Diagnosis judge_tiles(const JobScene3D *scene, const Work *found)
{
    const int width = scene->scene.width, height = scene->scene.height;
    int n = 0, n_tiles = 0, first_x = 0, first_y = 0, more_nodes = 0, more_tests = 0;
    int n_asked = 0, must_ask = 0;
    Work first = {0}, first_most = {0};
    for (int y = 0; y < height; y += TILE_SIDE) {
        for (int x = 0; x < width; x += TILE_SIDE, n_tiles++) {
            int must_tile;
            const Work work = found[y * width + x], most = tile_10_most(scene, x, y, &must_tile);
            n_asked += work.n_tests > 0;
            must_ask |= must_tile;
            if (work_is_at_most(work, most)) {
                continue;
            }
            more_nodes |= work.n_nodes_visited > most.n_nodes_visited ||
                          work.n_leaves_visited > most.n_leaves_visited ||
                          work.stack_depth > most.stack_depth;
            more_tests |= work.n_tests > most.n_tests;
            if (n++ == 0) {
                first_x = x, first_y = y, first = work, first_most = most;
            }
        }
    }
    if (must_ask && n_asked == 0) {
        return diagnosis_of(message_new("%s: found no tile that asks a sphere, but rays hit some",
                                        scene->picture.title),
                            (Cause){.says = "the search ends before it comes to a leaf that they "
                                            "need, or its work is hidden and cannot be counted"});
    }
    if (n == 0) {
        return NOTHING_WRONG;
    }
    char *wrong = message_new(
        "%s: the tile from pixel (%d, %d) on: found %s, expected at most %u, %u, %u and %u (%d of "
        "%d tiles do more than they need to)",
        scene->picture.title, first_x, first_y, work_words(first).text, first_most.n_nodes_visited,
        first_most.n_leaves_visited, first_most.n_tests, first_most.stack_depth, n, n_tiles);
    return diagnosis_of(wrong, cause_of_work(more_nodes, more_tests));
}

static Verdict judge_work(const void *pointer, int k, const Sections *answers)
{
    const JobScene3D *scene = &((const Job10 *)pointer)->scenes[k];
    const Work *found = job_work_find(&scene->picture, k, answers);
    return found == NULL ? verdict_missing : verdict_of(judge_tiles(scene, found));
}

// ---- The judge ----------------------------------------------------------------------------------

// What the search for spheres is made of.
#define SPHERE_TASKS "plane_interval next_tile_child next_tile_waiting cone_misses_sphere"

static const JudgeCheck checks[] = {
    {"leaf-tile", "The leaf of a tile", "tile_leaf", .function = &tile_leaf_10,
     .range = {0, N_CIRCLE_TILES}},
    {"leaf-steps", "One step a level, no more", "tile_leaf", .function = &leaf_steps_10,
     .range = {0, N_CIRCLE_TILES}},
    {"circles-pixels", "Tiles of circles, pixel by pixel", "tile_leaf", "paint_row",
     .function = &circle_pixels_10, .range = {0, N_CIRCLE_TILES},
     .alone_functions = {&tile_leaf_10}},

    {"row-open", "A row that nothing is painted in yet", "paint_row", .function = &circle_row_10,
     .range = RANGE(ROWS_OPEN, N_ROW_INPUTS)},
    {"row-painted", "A row that is painted in part", "paint_row", .function = &circle_row_10,
     .range = RANGE(ROWS_PAINTED, N_ROW_INPUTS)},
    {"circles-work", "No circle is asked behind a tile that is done", "paint_row", "tile_leaf",
     .function = &circle_work_10, .range = {0, N_CIRCLE_TILES},
     .alone_functions = {&circle_row_10}},

    {"plane-one-way", "All rays go the same way", "plane_interval", .function = &tile_plane_10,
     .range = RANGE(TILES_ONE_WAY, N_TILE_PLANE_INPUTS)},
    {"plane-both-ways", "Some go up, some down, some along", "plane_interval",
     .function = &tile_plane_10, .range = RANGE(TILES_BOTH_WAYS, N_TILE_PLANE_INPUTS)},
    {"plane-eye", "The eye is on the plane", "plane_interval", .function = &tile_plane_10,
     .range = RANGE(TILES_ON_PLANE, N_TILE_PLANE_INPUTS)},

    {"child-one", "Where all rays meet one child", "next_tile_child", .function = &tile_child_10,
     .range = RANGE(0, N_TILE_CHILD_INPUTS)},
    {"child-both", "Where both are met: one waits", "next_tile_child", .function = &tile_child_10,
     .range = RANGE(1, N_TILE_CHILD_INPUTS)},
    {"tile-hits", "No pinholes, in no scene", "next_tile_child", SPHERE_TASKS, .scene = judge_hits,
     .range = {0, N_SCENES}, .alone_functions = {&tile_child_10}},
    {"tile-picture", "Whole pictures", "next_tile_child", SPHERE_TASKS, .scene = judge_picture,
     .range = {0, N_SCENES}, .alone_functions = {&tile_child_10}},

    {"waiting-end", "When the search is over", "next_tile_waiting", .function = &tile_end_10,
     .range = {0, N_TILE_WAITING_INPUTS}},
    {"waiting-next", "What comes next where it is not", "next_tile_waiting",
     .function = &tile_next_10, .range = {0, N_TILE_WAITING_INPUTS}},
    {"tile-work", "No more work than a tile needs", "next_tile_waiting", SPHERE_TASKS,
     .scene = judge_work, .range = {0, N_SCENES}, .alone_functions = {&tile_end_10, &tile_next_10}},

    {"cone-clear", "Hit or missed by far", "cone_misses_sphere", .function = &cone_10,
     .range = RANGE(CONES_CLEAR, N_CONE_INPUTS)},
    {"cone-hair", "Hit or missed by a hair", "cone_misses_sphere", .function = &cone_10,
     .range = RANGE(CONES_HAIR, N_CONE_INPUTS)},
    {"cone-edges", "Around the eye, behind it, of any size", "cone_misses_sphere",
     .function = &cone_10, .range = RANGE(CONES_EDGES, N_CONE_INPUTS)},
};

static const JobPart parts[] = {
    INPUTS("tile_planes", "plane_interval", Job10, planes),
    INPUTS("tile_children", "next_tile_child", Job10, children),
    INPUTS("tile_waiting", "next_tile_waiting", Job10, waiting, .suspect = suspect_waiting_10),
    INPUTS("cones", "cone_misses_sphere", Job10, cones),
    INPUTS("circle_rows", "paint_row", Job10, rows),
    DATA("circle_nodes", "tile_leaf", Job10, circle_nodes),
    DATA("leaf_circles", "tile_leaf", Job10, leaf_circles),
    INPUTS("tile_leaves", "tile_leaf", Job10, circle_tiles),
    INPUTS("circle_tiles", "tile_leaf paint_row", Job10, circle_tiles, .is_apart = 1),
};

const Judge judge_10 = {
    .lab = "10-realtime",
    .checks = checks,
    .n_checks = COUNT(checks),
    .job_bytes = sizeof(Job10),
    .roll = roll,
    .parts = parts,
    .n_parts = COUNT(parts),
    .scenes = SCENES(job_scene3d_kind, Job10, scenes),
    .scene_steps = {{"picture", "in trace_tile", NULL}},
    .write_scene = write_scene,
};
