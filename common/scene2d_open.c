// 2D scenes by name: the way from the word after --scene to circles (see scene2d.h).
//
// Read next: scene2d_csv.c for files, scene2d_generate.c for scenes that are made.
#include "scene2d.h"

#include "scene_arguments.h"
#include "text_file.h"

static int csv_open(const char *path, Scene2D *scene)
{
    FILE *file = text_file_open(path);
    if (file == NULL) {
        return -1;
    }
    int result = scene2d_read_csv(file, path, scene);
    fclose(file);
    return result;
}

int scene2d_open(const char *name, int width, int height, Scene2D *scene)
{
    if (!scene_name_ends_in(name, ".csv")) {
        return scene2d_generate(name, width, height, scene);
    }
    const int size_is_given = width > 0 && height > 0;
    *scene = (Scene2D){.width = size_is_given ? width : SCENE2D_DEFAULT_SIZE,
                       .height = size_is_given ? height : SCENE2D_DEFAULT_SIZE};
    return csv_open(name, scene);
}
