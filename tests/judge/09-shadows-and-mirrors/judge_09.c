// Judge of lab 09: each function on chosen inputs, and whole pictures. The functions' inputs are
// rolled and judged in the files that judge_09.h names.
//
// Pictures are those of an oracle that follows each ray in double precision, with a bound for every
// pixel that grows from mirror to mirror; what rounding may decide on the way is left out. Read
// next: judge_09.h.
#include "judge_09.h"

// ---- Rolling the job ----------------------------------------------------------------------------

static int roll(void *pointer, Random *random)
{
    Job09 *job = pointer;
    roll_starts_09(random, job);
    roll_rays_09(random, job);
    roll_blocks_09(random, job);
    roll_alone_09(random, job);
    if (roll_scenes_09(random, job->scenes) != 0) {
        return -1;
    }
    roll_lits_09(random, job);
    add_calls_09(random, job);
    for (int k = 0; k < N_SCENES; k++) {
        job->scenes[k].nonce = job->job.nonce;
    }
    return 0;
}

static int write_scene(const void *job, int k, FILE *file)
{
    return scene_09_write(&((const Job09 *)job)->scenes[k], k, file);
}

// ---- The judge ----------------------------------------------------------------------------------

static const JudgeCheck checks[] = {
    {"leave-side", "Along the normal, and far enough", "leave_surface", .function = &start_09,
     .range = RANGE(0, N_START_INPUTS)},
    {"leave-scale", "With numbers of any size", "leave_surface", .function = &start_09,
     .range = RANGE(1, N_START_INPUTS)},

    {"mirror-direction", "The angle of exit is that of entry", "mirrored_direction",
     .function = &mirror_09, .range = RANGE(0, N_MIRROR_INPUTS)},
    {"mirror-edges", "Head-on, grazing, along axes", "mirrored_direction", .function = &mirror_09,
     .range = RANGE(1, N_MIRROR_INPUTS)},

    {"ray-origin", "From the point, with t_min 0", "shadow_ray", .function = &ray_origin_09,
     .range = {0, N_SHADOW_RAY_INPUTS}},
    {"ray-direction", "To the light, a unit vector", "shadow_ray", .function = &ray_direction_09,
     .range = {0, N_SHADOW_RAY_INPUTS}},
    {"ray-end", "As far as the light", "shadow_ray", .function = &ray_end_09,
     .range = {0, N_SHADOW_RAY_INPUTS}},

    {"blocks-before", "Before the end of the ray, and behind it", "leaf_blocks",
     .function = &block_09, .range = RANGE(0, N_BLOCK_INPUTS)},
    {"blocks-edges", "By a hair", "leaf_blocks", .function = &block_09,
     .range = RANGE(1, N_BLOCK_INPUTS)},
    {"blocks-early", "The first one that is found ends the search", "leaf_blocks",
     .function = &block_early_09, .range = {0, N_BLOCKS}},

    {"lit-shadow", "One light, and what may stand between", "lit_color", "shadow_ray leaf_blocks",
     .function = &lit_09, .range = RANGE(0, N_LIT_INPUTS), .alone = lits_alone_09,
     .alone_cause = judge_function_alone},
    {"lit-behind", "A ray for each light before the surface, and no other", "lit_color",
     "shadow_ray leaf_blocks", .function = &lit_09, .range = RANGE(1, N_LIT_INPUTS),
     .alone = lits_alone_09, .alone_cause = judge_function_alone},
    {"lit-lights", "Every light for itself", "lit_color", "shadow_ray leaf_blocks",
     .function = &lit_09, .range = RANGE(2, N_LIT_INPUTS), .alone = lits_alone_09,
     .alone_cause = judge_function_alone},

    {"color-local", "Without mirrors", "ray_color", "*", .scene = judge_picture,
     .range = {LOCAL, N_LOCAL}, .alone_scene = picture_alone_09, .alone_cause = picture_cause_09},
    {"color-mirrors", "One mirror or two", "ray_color", "*", .scene = judge_picture,
     .range = {MIRRORS, N_MIRRORS}, .alone_scene = picture_alone_09,
     .alone_cause = picture_cause_09},
    {"color-end", "Many mirrors, and where the end is", "ray_color", "*", .scene = judge_picture,
     .range = {ENDS, N_ENDS}, .alone_scene = picture_alone_09, .alone_cause = picture_cause_09},
    {"color-background", "The background over mirrors", "ray_color", "*", .scene = judge_picture,
     .range = {BACKGROUNDS, N_BACKGROUNDS}, .alone_scene = picture_alone_09,
     .alone_cause = picture_cause_09},
    {"color-rays", "No ray that adds nothing", "ray_color", "*", .scene = judge_sent_09,
     .range = {0, N_SENT_SCENES}, .alone_scene = sent_alone_09},
};

static const JobPart parts[] = {
    INPUTS("starts", "leave_surface", Job09, starts),
    INPUTS("mirrors", "mirrored_direction", Job09, mirrors),
    INPUTS("shadow_rays", "shadow_ray", Job09, shadow_rays),
    INPUTS("blocks", "leaf_blocks", Job09, blocks),
    DATA("block_ids", "leaf_blocks", Job09, block_ids),
    DATA("block_spheres", "leaf_blocks", Job09, block_spheres),
    INPUTS("lits", "lit_color", Job09, lits,
           .is_apart = 1),  // alone with other points: write_alone_09()
    DATA("lit_lights", NULL, Job09, lit_lights),
};

const Judge judge_09 = {
    .lab = "09-shadows-and-mirrors",
    .checks = checks,
    .n_checks = COUNT(checks),
    .job_bytes = sizeof(Job09),
    .roll = roll,
    .parts = parts,
    .n_parts = COUNT(parts),
    .scenes = SCENES(job_scene3d_kind, Job09, scenes),
    .scene_steps = {{"picture", "in render_mirrors", NULL}},
    .write_scene = write_scene,
    .write_alone = write_alone_09,
};
