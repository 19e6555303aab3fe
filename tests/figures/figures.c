// Drawing figures of a followed pixel (see figures.h).
#include "figures.h"

#include "complain.h"
#include "output_file.h"

static void figure_draw(const char *folder, const Figure *figure, const Followed *followed)
{
    char *path;
    if (asprintf(&path, "%s/%s", folder, figure->name) < 0) {
        complain("no memory");
        exit(EXIT_FAILURE);
    }
    OutputFile output;
    require(output_file_open(&output, path));
    figure->draw(output.file, followed);
    require(output_file_commit(&output));
    free(path);
}

void figures_draw(const char *folder, char **options, const Figure *figures)
{
    int n_options = 0;
    while (options[n_options] != NULL) {
        n_options++;
    }
    Lab lab = lab_begin(n_options, options, WORLD_LAB.name, "Draws figures.",
                        world_options(&WORLD_LAB) | OPTIONS_PIXEL);
    World world;
    require(world_open(&world, &lab, &WORLD_LAB));
    Followed *followed = world_allocate(sizeof *followed);
    require(followed_make(followed, &world, &WORLD_LAB, lab.options.pixel_x, lab.options.pixel_y));
    for (; figures->name != NULL; figures++) {
        figure_draw(folder, figures, followed);
    }
    free(followed);
    world.kind->close(&world);
    cl_setup_close(&lab.cl);
}
