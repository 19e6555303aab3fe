// The figures of the second half and of realtime: the worked example's ray, one that meets every
// case, one of balls A and B, and a row of rays.
//
//     figures3d FOLDER
#include "figures3d.h"

#include "complain.h"

int main(int argc, char **argv)
{
    if (argc != 2) {
        complain("usage: figures3d FOLDER");
        return EXIT_FAILURE;
    }
    char *worked[] = {argv[0], "--scene", "tests/scenes/worked.nff", "--leaf-size", "1", "--pixel",
                      "1,1",   NULL};
    static const Figure OF_WORKED[] = {
        {"04-camera.svg", draw_camera},   {"05-half-chord.svg", draw_half_chord},
        {"05-hits.svg", draw_hits},       {"06-planes.svg", draw_planes},
        {"07-search.svg", draw_search3d}, {"07-slabs.svg", draw_slabs},
        {"07-stack.svg", draw_stack},     {"08-cost.svg", draw_cost},
        {"09-rays.svg", draw_light},      {"10-tile.svg", draw_tile},
        {"10-light.svg", draw_ways},      {NULL, NULL},
    };
    figures_draw(argv[1], worked, OF_WORKED);
    char *inside[] = {argv[0], "--scene", "inside", "--pixel", "256,256", NULL};
    static const Figure OF_INSIDE[] = {{"07-cases.svg", draw_cases}, {NULL, NULL}};
    figures_draw(argv[1], inside, OF_INSIDE);
    char *balls[] = {argv[0],       "--scene", "tests/scenes/balls.nff",
                     "--max-depth", "2",       "--leaf-size",
                     "1",           "--pixel", "1,1",
                     NULL};
    static const Figure OF_BALLS[] = {{"07-balls.svg", draw_balls}, {NULL, NULL}};
    figures_draw(argv[1], balls, OF_BALLS);
    char *row[] = {argv[0], "--scene", "sphereflake", "--pixel", "176,300", NULL};
    static const Figure OF_ROW[] = {{"10-divergence.svg", draw_lanes}, {NULL, NULL}};
    figures_draw(argv[1], row, OF_ROW);
    return EXIT_SUCCESS;
}
