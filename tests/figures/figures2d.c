// The figures in two dimensions: the lecture's example, the search for pixel 7, 7, lab 08's
// question asked of circles, and lab 10's planes.
//
//     figures2d FOLDER
#include "figures2d.h"

#include "complain.h"

int main(int argc, char **argv)
{
    if (argc != 2) {
        complain("usage: figures2d FOLDER");
        return EXIT_FAILURE;
    }
    char *options[] = {argv[0],       "--scene", "example", "--max-depth", "4",
                       "--leaf-size", "1",       "--pixel", "7,7",         NULL};
    static const Figure FIGURES[] = {
        {"00-host-device.svg", draw_host},
        {"00-work-groups.svg", draw_groups},
        {"01-sample-point.svg", draw_sample},
        {"02-tree.svg", draw_tree},
        {"02-arrays.svg", draw_arrays},
        {"02-failed-split.svg", draw_failed},
        {"03-descent.svg", draw_descent},
        {"03-search.svg", draw_search},
        {"08-weights.svg", draw_weights},
        {"10-borders.svg", draw_borders},
        {NULL, NULL},
    };
    figures_draw(argv[1], options, FIGURES);
    return EXIT_SUCCESS;
}
