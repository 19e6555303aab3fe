// 3D scenes by name: the way from the word after --scene to spheres and a view (see scene3d.h).
//
// Read next: scene3d_nff.c and molecule.c for files, scene3d_generate.c for scenes that are made.
#include "scene3d.h"

#include "complain.h"
#include "molecule.h"
#include "scene3d_nff.h"
#include "scene_arguments.h"
#include "text_file.h"

static int file_open(const char *path, int (*read)(FILE *file, const char *name, Scene3D *scene),
                     Scene3D *scene)
{
    FILE *file = text_file_open(path);
    if (file == NULL) {
        return -1;
    }
    int result = read(file, path, scene);
    fclose(file);
    return result;
}

static int mmcif_refuse(FILE *file, const char *name, Scene3D *scene)
{
    (void)file;
    (void)scene;
    complain("%s: found a molecule as mmCIF, expected PDB or XYZ, which databases of molecules "
             "offer, too",
             name);
    return -1;
}

int scene3d_open(const char *name, int width, int height, Scene3D *scene)
{
    static const struct {
        const char *ending;
        int (*read)(FILE *file, const char *name, Scene3D *scene);
    } formats[] = {{".nff", scene3d_read_nff}, {".pdb", scene3d_read_pdb},
                   {".ent", scene3d_read_pdb}, {".xyz", scene3d_read_xyz},
                   {".cif", mmcif_refuse},     {".mmcif", mmcif_refuse}};
    for (size_t i = 0; i < sizeof formats / sizeof *formats; i++) {
        if (scene_name_ends_in(name, formats[i].ending)) {
            *scene = (Scene3D){.width = SCENE3D_DEFAULT_SIZE, .height = SCENE3D_DEFAULT_SIZE};
            const int result = file_open(name, formats[i].read, scene);
            return scene3d_settle(name, width, height, result, scene);
        }
    }
    return scene3d_generate(name, width, height, scene);
}
