// common/molecule and elements: atoms become spheres, which are all in view, wherever a file stops
// and however large it is.
#include "molecule_samples.h"
#include "random.h"

TestSuite(molecule, .init = folder_enter, .fini = folder_leave);

// ---- Elements -----------------------------------------------------------------------------------

Test(molecule, elements_by_symbol_and_number)
{
    static const struct {
        const char *text;
        int number;  // 0: unknown
    } CASES[] = {
        {"H", 1},   {"h", 1},       {"D", 1},     {"C", 6},   {"Cl", 17}, {"CL", 17},
        {"cl", 17}, {"cL", 17},     {"Es", 99},   {"I", 53},  {"In", 49}, {"IN", 49},
        {"C1", 6},  {"C_alpha", 6}, {"Fe2+", 26}, {"Clx", 0}, {"X", 0},   {"", 0},
        {"1H", 0},  {"@", 0},       {"C\xFF", 6}, {"DX", 0},  {"Fm", 0},
    };
    for (size_t i = 0; i < sizeof CASES / sizeof CASES[0]; i++) {
        cr_expect_eq(element_by_symbol(CASES[i].text), element_by_number(CASES[i].number), "%s",
                     CASES[i].text);
    }
    cr_expect_str_eq(element_by_number(79)->symbol, "Au");
    cr_expect_str_eq(element_by_number(99)->symbol, "Es");
    cr_expect_null(element_by_number(0));
    cr_expect_null(element_by_number(-1));
    cr_expect_null(element_by_number(100));
    cr_expect_null(element_by_number(INT64_MAX));
}

Test(molecule, radii_are_angstrom)
{
    cr_expect_eq(element_by_symbol("C")->radius, 1.70f);  // Bondi
    cr_expect_eq(element_by_symbol("O")->radius, 1.52f);
    for (int i = 1; i <= 99; i++) {
        const float radius = element_by_number(i)->radius;
        cr_expect(radius >= 1.2f && radius <= 3.5f, "element %d: %g", i, (double)radius);
        cr_expect_leq(element_by_number(i)->color, 0xFFFFFF);
    }
}

// ---- The view -----------------------------------------------------------------------------------

// Is every atom inside the cone around the view? All in double, from what the scene says.
static void expect_all_in_view(const Scene3D *scene)
{
    const View *view = &scene->view;
    const double direction[3] = {(double)view->at.x - view->from.x,
                                 (double)view->at.y - view->from.y,
                                 (double)view->at.z - view->from.z};
    const double length = sqrt(direction[0] * direction[0] + direction[1] * direction[1] +
                               direction[2] * direction[2]);
    const double half_angle = (double)view->angle / 2 * M_PI / 180;
    cr_assert_null(scene3d_view_fault(view));
    for (int i = 0; i < scene->n_spheres; i++) {
        const Sphere *atom = &scene->spheres[i];
        const double to_atom[3] = {(double)atom->x - view->from.x, (double)atom->y - view->from.y,
                                   (double)atom->z - view->from.z};
        double ahead = 0, distance2 = 0;
        for (int axis = 0; axis < 3; axis++) {
            ahead += to_atom[axis] * direction[axis] / length;
            distance2 += to_atom[axis] * to_atom[axis];
        }
        const double seen_at = acos(fmin(ahead / sqrt(distance2), 1));
        const double seen_radius = asin(atom->radius / sqrt(distance2));
        cr_expect_lt(seen_at + seen_radius, half_angle, "atom %d is cut off", i);
    }
}

Test(molecule, all_atoms_are_in_view)
{
    Random random = {1};
    for (int round = 0; round < 300; round++) {
        // Flat ones, long ones, far ones, single ones.
        const int n_atoms = (int)random_integer(&random, 1, 40);
        const int extent[3] = {(int)random_integer(&random, 0, 100),
                               (int)random_integer(&random, 0, 30),
                               (int)random_integer(&random, 0, 3)};
        const int turn = (int)random_integer(&random, 0, 2);
        const int far = round % 10 == 0 ? 999000 : 0;
        FILE *file = tmpfile();
        fprintf(file, "%d\n\n", n_atoms);
        for (int i = 0; i < n_atoms; i++) {
            fprintf(file, "%d", (int)random_integer(&random, 1, 99));
            for (int axis = 0; axis < 3; axis++) {
                const int reach = extent[(axis + turn) % 3];
                fprintf(file, " %g", (double)random_grid(&random, far - reach, far + reach));
            }
            fputs("\n", file);
        }
        rewind(file);
        Scene3D scene;
        cr_assert_eq(scene3d_read_xyz(file, "random.xyz", &scene), 0);
        fclose(file);
        expect_all_in_view(&scene);
        cr_expect(scene.n_lights == 3 && scene.view.angle >= 30 && scene.view.angle <= 45);
        cr_expect(scene.width == SCENE3D_DEFAULT_SIZE && scene.height == SCENE3D_DEFAULT_SIZE);
        scene3d_free(&scene);
    }
}

Test(molecule, a_flat_molecule_shows_its_face)
{
    Scene3D scene = read_good(scene3d_read_xyz, "3\n\nC 0 5 0\nC 0 -5 9\nC 0 5 -9\n", "");
    const Vec3 view = vec3_normalized(vec3_minus(scene.view.from, scene.view.at));
    cr_expect_gt(fabsf(view.x), 0.8f);
    cr_expect(scene.view.up.y == 1 && scene.view.up.z == 0);
    scene3d_free(&scene);
}

// ---- Files that stop anywhere, and large ones ---------------------------------------------------

Test(molecule, cut_anywhere)
{
    static const struct {
        Read *read;
        const char *text;
    } FILES[] = {
        {scene3d_read_xyz, "3\r\ncomment\r\nO 0 0 0.5\r\nXy 1 -2.5 3e0 more\r\n6 1 1 1\r\n\r\n3\n"},
        {scene3d_read_pdb, "HEADER\nMODEL 1\n" CA_ATOM "TER\n" CA_ATOM
                           "HETATM    3 FE  HEM A   1      -1.000   2.500   3.000  1.00  0.00\n"
                           "HETATM    3 X1  HEM A   1      -1.000   2.500   3.000\nENDMDL\nEND\n"},
    };
    for (size_t i = 0; i < sizeof FILES / sizeof FILES[0]; i++) {
        expect_cut_anywhere(FILES[i].read, FILES[i].text);
    }
}

Test(molecule, a_million_atoms_take_seconds)
{
    FILE *file = tmpfile();
    fputs("1000000\n\n", file);
    for (int i = 0; i < 1000000; i++) {
        fprintf(file, "C %d.0625 12.5 3.25\n", i % 1000);
    }
    rewind(file);
    Scene3D scene;
    cr_assert_eq(scene3d_read_xyz(file, "large.xyz", &scene), 0);
    fclose(file);
    cr_expect_eq(scene.n_spheres, 1000000);
    cr_expect_eq(scene.n_materials, 1);
    scene3d_free(&scene);
}

// ---- The samples --------------------------------------------------------------------------------

// Outside the suite, and so in the top folder.
Test(molecule_samples, are_read)
{
    static const struct {
        const char *path;
        int n_atoms;
        int n_materials;
    } SAMPLES[] = {{"tests/scenes/caffeine.xyz", 24, 4},
                   {"tests/scenes/c60.xyz", 60, 1},
                   {"tests/scenes/helix.pdb", 159, 4}};
    for (size_t i = 0; i < sizeof SAMPLES / sizeof SAMPLES[0]; i++) {
        Scene3D scene;
        cr_assert_eq(scene3d_open(SAMPLES[i].path, 0, 0, &scene), 0, "start in the top folder");
        cr_expect_eq(scene.n_spheres, SAMPLES[i].n_atoms, "%s", SAMPLES[i].path);
        cr_expect_eq(scene.n_materials, SAMPLES[i].n_materials, "%s", SAMPLES[i].path);
        expect_all_in_view(&scene);
        scene3d_free(&scene);
    }
}
