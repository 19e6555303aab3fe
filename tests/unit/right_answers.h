// The right answers to a lab's job, worked out on the host: what a probe writes around the lab's
// solution.
//
// They share no code with the kernels. Each header has the answerers of some labs; a section is
// written as jobs.h has it. Read next: right_answers_2d.h.
#ifndef UNIT_RIGHT_ANSWERS_H
#define UNIT_RIGHT_ANSWERS_H

#include "judge_07.h"
#include "right_answers_2d.h"
#include "right_answers_3d.h"
#include "right_answers_mirrors.h"
#include "right_answers_sah.h"
#include "right_answers_tiles.h"
#include "right_answers_tree3d.h"

// As lab_names of test_judges.c has them. Free with sections_free().
static Sections right_answers(int lab, const Sections *job)
{
    // The scenes whose work is judged.
    static const int work_05[] = {1, 4, 7};  // SMALL, TIES and "behind"
    static const int work_07[] = {RANDOM + 2, RANDOM + 6, RANDOM + 7, RANDOM + N_RANDOM - 1,
                                  DEEP,       FLAKE};
    static const int work_09[] = {0, 8, 16, 21};  // those of judge_09_sent.c
    int work_10[N_TILE_SCENES];
    for (int k = 0; k < N_TILE_SCENES; k++) {
        work_10[k] = k;
    }
    Writer writer;
    writer_open(&writer);
    switch (lab) {
    case 0:
        answer_pictures(&writer, lab, job);
        break;
    case 1:
        answer_overlaps(&writer, job);
        answer_pictures(&writer, lab, job);
        break;
    case 2:
        answer_leaves_and_boxes(&writer, job);
        answer_lists(&writer, job);
        answer_trees(&writer, job);
        break;
    case 3:
        answer_children(&writer, job);
        answer_pictures(&writer, lab, job);
        break;
    case 4:
        answer_axes_and_pixels(&writer, job);
        answer_pictures_3d(&writer, job, NULL, NULL, NULL, 0);
        break;
    case 5:
        answer_sphere_functions(&writer, job);
        answer_pictures_3d(&writer, job, find_in_all, hit_color, work_05,
                           sizeof work_05 / sizeof *work_05);
        break;
    case 6:
        answer_planes_and_overlaps(&writer, job);
        answer_leaves_3d(&writer, job);
        answer_trees_3d(&writer, job);
        break;
    case 7:
        answer_clips_and_sides(&writer, job);
        answer_planes_and_leaves(&writer, job);
        answer_steps(&writer, job);
        answer_pictures_3d(&writer, job, find_in_tree, hit_color, work_07,
                           sizeof work_07 / sizeof *work_07);
        break;
    case 8:
        answer_areas_and_costs(&writer, job);
        answer_best_splits(&writer, job);
        answer_decisions(&writer, job);
        answer_trees_sah(&writer, job);
        break;
    case 9:
        answer_rays(&writer, job);
        answer_blocks(&writer, job);
        answer_lits(&writer, job);
        answer_pictures_3d(&writer, job, find_in_leaf, color_over_mirrors, work_09,
                           sizeof work_09 / sizeof *work_09);
        break;
    default:
        answer_tile_planes(&writer, job);
        answer_tile_children(&writer, job);
        answer_tile_waiting(&writer, job);
        answer_cones(&writer, job);
        answer_circle_rows(&writer, job);
        answer_circle_tiles(&writer, job);
        answer_pictures_3d(&writer, job, find_for_nothing, hit_color, work_10, N_TILE_SCENES);
    }
    return writer_close(&writer);
}

#endif
