// The figures of the second half: the worked example's ray, and one that meets every case.
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
        {"04-camera.svg", draw_camera}, {"05-half-chord.svg", draw_half_chord},
        {"05-hits.svg", draw_hits},     {"07-slabs.svg", draw_slabs},
        {"07-stack.svg", draw_stack},   {NULL, NULL},
    };
    figures_draw(argv[1], worked, OF_WORKED);
    char *inside[] = {argv[0], "--scene", "inside", "--pixel", "256,256", NULL};
    static const Figure OF_INSIDE[] = {{"07-cases.svg", draw_cases}, {NULL, NULL}};
    figures_draw(argv[1], inside, OF_INSIDE);
    return EXIT_SUCCESS;
}
