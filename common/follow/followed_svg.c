// A followed pixel as a picture (see followed.h): the file, and which of the two kinds of pictures.
//
// Read next: ray_svg.c, cell_svg.c.
#include "followed_svg.h"

#include "output_file.h"

int followed_save_svg(const Followed *followed, const char *path)
{
    OutputFile output;
    if (output_file_open(&output, path) != 0) {
        return -1;
    }
    if (followed->world->kind == &CIRCLES) {
        cell_svg(followed, output.file);
    } else {
        ray_svg(followed, output.file);
    }
    return output_file_commit(&output);
}
