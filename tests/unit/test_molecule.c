// common/molecule: PDB and XYZ files, whatever the text may hold; every atom in view.
#include "elements.h"
#include "random.h"
#include "scene3d.h"
#include "surroundings.h"

#include <math.h>

TestSuite(molecule, .init = folder_enter, .fini = folder_leave);

// Text with its length, so that it may hold NUL bytes.
#define TEXT(literal) literal, sizeof(literal) - 1

typedef int Read(FILE *file, const char *name, Scene3D *scene);

static int read_text(Read *read, const char *text, size_t length, Scene3D *scene)
{
    *scene = (Scene3D){0};
    FILE *file = tmpfile();
    fwrite(text, 1, length, file);
    rewind(file);
    int result = read(file, "molecule", scene);
    fclose(file);
    return result;
}

// Read text that is good, and expect this warning, or "".
static Scene3D read_good(Read *read, const char *text, const char *warning)
{
    Scene3D scene;
    capture_begin(2);
    int result = read_text(read, text, strlen(text), &scene);
    const char *message = capture_end(2);
    cr_assert_eq(result, 0, "%s", message);
    cr_expect_str_eq(message, warning);
    return scene;
}

static void expect_fault(Read *read, const char *text, size_t length, const char *fault)
{
    Scene3D scene;
    char expected[256];
    capture_begin(2);
    int result = read_text(read, text, length, &scene);
    const char *message = capture_end(2);
    snprintf(expected, sizeof expected, "molecule:%s\n", fault);
    cr_expect_str_eq(message, expected);
    cr_expect_eq(result, -1, "was read: %s", fault);
    cr_expect_null(scene.spheres);
}

static void expect_atom(const Scene3D *scene, int i, float x, float y, float z, const char *symbol)
{
    const Element *element = symbol == NULL ? &ELEMENT_UNKNOWN : element_by_symbol(symbol);
    const Sphere *atom = &scene->spheres[i];
    const Vec3 color = scene->materials[scene->material_ids[i]].color;
    cr_expect(atom->x == x && atom->y == y && atom->z == z, "atom %d is at %g %g %g", i,
              (double)atom->x, (double)atom->y, (double)atom->z);
    cr_expect_eq(atom->radius, element->radius, "atom %d: radius %g", i, (double)atom->radius);
    cr_expect_eq((uint32_t)lrintf(255 * color.x) << 16 | (uint32_t)lrintf(255 * color.y) << 8 |
                     (uint32_t)lrintf(255 * color.z),
                 element->color, "atom %d has another colour", i);
}

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

// ---- XYZ ----------------------------------------------------------------------------------------

Test(molecule, xyz_is_read)
{
    static const char *const TEXTS[] = {
        "2\nwater, a part of it\nO 0 0 0.5\nH 1 -2.5 3\n",
        "2\n\nO 0 0 0.5\nH 1 -2.5 3 ",
        "2\r\ncomment\r\nO 0 0 0.5\r\nH 1 -2.5 3\r\n\r\n",
        "\xEF\xBB\xBF 2 \n\no 0 0 0.5\nh 1 -2.5 3\n\n \n",
        "2\n\n8\t0\t0\t0.5\n 1   1 -2.5 3\n",
        "2\n\nO1 0 0 0.5 -0.8 charge\nH2 1 -25e-1 3. 0.4 # 1 2 3 4 5 6 7 8 9\n",
        "2\n\nO 0 0 0.5\nH 1 -2.5 3\n2\nthe next frame\nwhatever",
    };
    for (size_t i = 0; i < sizeof TEXTS / sizeof TEXTS[0]; i++) {
        Scene3D scene = read_good(scene3d_read_xyz, TEXTS[i], "");
        cr_assert_eq(scene.n_spheres, 2, "case %zu", i);
        expect_atom(&scene, 0, 0, 0, 0.5f, "O");
        expect_atom(&scene, 1, 1, -2.5f, 3, "H");
        scene3d_free(&scene);
    }
}

Test(molecule, an_xyz_file_without_its_last_line_end_is_warned_of)
{
    Scene3D scene =
        read_good(scene3d_read_xyz, "2\n\nO 0 0 0.5\nH 1 -2.5 3",
                  "molecule: warning: the last line (4) has no line end: if the file was "
                  "cut there, its last number is wrong\n");
    expect_atom(&scene, 1, 1, -2.5f, 3, "H");
    scene3d_free(&scene);
}

Test(molecule, xyz_faults)
{
    static const struct {
        const char *text;
        size_t length;
        const char *fault;
    } CASES[] = {
        {TEXT(""),
         "1: found the end of the file, expected the number of atoms, from 1 to 10000000"},
        {TEXT("\n"), "1: found 0 words, expected the number of atoms, from 1 to 10000000"},
        {TEXT("C 0 0 0\n"), "1: found 4 words, expected the number of atoms, from 1 to 10000000"},
        {TEXT("two\n"), "1: found \"two\", expected the number of atoms, from 1 to 10000000"},
        {TEXT("0\n\n"), "1: found \"0\", expected the number of atoms, from 1 to 10000000"},
        {TEXT("-1\n\n"), "1: found \"-1\", expected the number of atoms, from 1 to 10000000"},
        {TEXT("10000001\n\n"),
         "1: found \"10000001\", expected the number of atoms, from 1 to 10000000"},
        {TEXT("99999999999999999999\n\n"),
         "1: found \"99999999999999999999\", expected the number of atoms, from 1 to 10000000"},
        {TEXT("1\n"), "2: found the end of the file, expected a comment, which may be empty"},
        {TEXT("2\n\n"), "3: found the end of the file after 0 atoms, expected 2"},
        {TEXT("2\n\nC 0 0 0\n"), "4: found the end of the file after 1 atom, expected 2"},
        {TEXT("1\n\nC 0 0\n"), "3: found 3 words, expected an element and its x, y and z"},
        {TEXT("1\n\n\nC 0 0 0\n"), "3: found 0 words, expected an element and its x, y and z"},
        {TEXT("1\n\nC 0 0 0\nC 1 1 1\n"),
         "4: found \"C\", expected no more atoms than line 1 says, 1"},
        {TEXT("1\n\nC 0 0 0\n\n1 1\n"),
         "5: found \"1\", expected no more atoms than line 1 says, 1"},
        {TEXT("1\n\nC nan 0 0\n"), "3: x: found \"nan\", expected a finite number"},
        {TEXT("1\n\nC 0 inf 0\n"), "3: y: found \"inf\", expected a finite number"},
        {TEXT("1\n\nC 0 0 1e999\n"), "3: z: found \"1e999\", expected a finite number"},
        {TEXT("1\n\nC 0 0 0x1\n"), "3: z: found \"0x1\", expected a finite number"},
        {TEXT("1\n\nC 0,5 0 0\n"), "3: x: found \"0,5\", expected a finite number"},
        {TEXT("1\n\nC 0 0 1000000.5\n"),
         "3: z: found \"1000000.5\", expected a number from -1000000 to 1000000"},
        {TEXT("1\n\nC x\033 y z\n"), "3: x: found \"x?\", expected a finite number"},
        {TEXT("1\n\nC 0 \0 0 0\n"), "3: found a NUL byte, expected text"},
        {TEXT("1\n\0\nC 0 0 0\n"), "2: found a NUL byte, expected text"},
    };
    for (size_t i = 0; i < sizeof CASES / sizeof CASES[0]; i++) {
        expect_fault(scene3d_read_xyz, CASES[i].text, CASES[i].length, CASES[i].fault);
    }
}

Test(molecule, unknown_elements_are_pink_and_named_once)
{
    Scene3D scene = read_good(scene3d_read_xyz, "3\n\nC 0 0 0\nXx 1 0 0\nXx 2 0 0\n",
                              "molecule: warning: drew 2 atoms of unknown elements in pink: "
                              "\"Xx\"\n");
    expect_atom(&scene, 2, 2, 0, 0, NULL);
    cr_expect_eq(scene.n_materials, 2);
    scene3d_free(&scene);

    scene = read_good(scene3d_read_xyz, "1\n\n200 0 0 0\n",
                      "molecule: warning: drew 1 atom of unknown elements in pink: \"200\"\n");
    scene3d_free(&scene);

    scene = read_good(scene3d_read_xyz,
                      "8\n\nX1 0 0 0\nX2 0 0 0\nX3 0 0 0\nX4 0 0 0\n\033 0 0 0\nX6 0 0 0\n"
                      "X7 0 0 0\nX1 0 0 0\n",
                      "molecule: warning: drew 8 atoms of unknown elements in pink: \"X1\", "
                      "\"X2\", \"X3\", \"X4\", \"?\" and others\n");
    scene3d_free(&scene);
}

// ---- PDB ----------------------------------------------------------------------------------------

//             1234567890123456789012345678901234567890123456789012345678901234567890123456789
#define CA_ATOM "ATOM      2  CA  ALA A   1      -1.000   2.500   3.000  1.00  0.00           C\n"

// One record with parts of it changed: the name, the location, the residue, the element.
static const char *record(const char *kind, const char *name, char location, int residue,
                          const char *element)
{
    static char line[128];
    snprintf(line, sizeof line,
             "%-6s    1 %-4s%cLIG A%4d      -1.000   2.500   3.000  1.00  0.00  "
             "        %2s\n",
             kind, name, location, residue, element);
    return line;
}

Test(molecule, pdb_is_read)
{
    static const char *const TEXTS[] = {
        CA_ATOM,
        "HEADER    WHATEVER\nREMARK 1 \xC3\xA4\n" CA_ATOM "TER\nEND\n",
        "MODEL        1\n" CA_ATOM "ENDMDL\nMODEL        2\n" CA_ATOM "ENDMDL\nEND\n",
        CA_ATOM "END\n" CA_ATOM,
        "ATOM      2  CA  ALA A   1      -1.000   2.500   3.000\n",  // without what follows
        "ATOM      2  CA  ALA A   1      -1.000   2.500   3.000\r\n",
        "ATOM      2  CA  ALA A   1      -1.000   2.500   3.0\n",
        "ATOM  99999  CA  ALA A9999A     -1.000   2.500   3.000  1.00  0.00      SEGM "
        "C1+\r\nEND\r\n",
        "HETATM    2  C1  LIG A   1      -1.000   2.500   3.000  1.00  0.00           C\n",
        "\xEF\xBB\xBF" CA_ATOM,
        "\n\n" CA_ATOM "ATOMS\nCONECT    1    2\nANISOU    1  N   ALA\n",
    };
    for (size_t i = 0; i < sizeof TEXTS / sizeof TEXTS[0]; i++) {
        Scene3D scene = read_good(scene3d_read_pdb, TEXTS[i], "");
        cr_assert_eq(scene.n_spheres, 1, "case %zu", i);
        expect_atom(&scene, 0, -1, 2.5f, 3, "C");
        scene3d_free(&scene);
    }
}

Test(molecule, pdb_columns_need_no_blanks_between)
{
    Scene3D scene = read_good(
        scene3d_read_pdb,
        "HETATM12345 FE   HEM A1234A   -999.123-999.4569999.999  1.00  0.00          FE\n", "");
    expect_atom(&scene, 0, -999.123f, -999.456f, 9999.999f, "Fe");
    scene3d_free(&scene);
}

Test(molecule, pdb_elements)
{
    static const struct {
        const char *kind, *name, *element;
        const char *expected;
    } CASES[] = {
        {"ATOM", " CA ", "C", "C"},     {"HETATM", "CA  ", "CA", "Ca"}, {"ATOM", " CA ", "", "C"},
        {"HETATM", "CA  ", "", "Ca"},   {"ATOM", "CA  ", "", "C"},      {"HETATM", " CA ", "", "C"},
        {"HETATM", "FE  ", "", "Fe"},   {"HETATM", "FE1 ", "", "Fe"},   {"ATOM", "HG11", "", "H"},
        {"HETATM", "HG11", "", "H"},    {"HETATM", "HG  ", "", "Hg"},   {"ATOM", "1HB ", "", "H"},
        {"HETATM", "1H  ", "", "H"},    {"HETATM", "HO5'", "", "H"},    {"HETATM", "C12A", "", "C"},
        {"HETATM", "CL12", "", "Cl"},   {"ATOM", " N  ", "N", "N"},     {"ATOM", " D  ", "D", "H"},
        {"HETATM", " X  ", "zn", "Zn"}, {"HETATM", " O  ", "O1", "O"},  {"ATOM", " O  ", "12", "O"},
    };
    for (size_t i = 0; i < sizeof CASES / sizeof CASES[0]; i++) {
        Scene3D scene = read_good(
            scene3d_read_pdb, record(CASES[i].kind, CASES[i].name, ' ', 1, CASES[i].element), "");
        expect_atom(&scene, 0, -1, 2.5f, 3, CASES[i].expected);
        scene3d_free(&scene);
    }
    Scene3D scene =
        read_good(scene3d_read_pdb, record("HETATM", " UNK", ' ', 1, "X"),
                  "molecule: warning: drew 1 atom of unknown elements in pink: \"X\"\n");
    expect_atom(&scene, 0, -1, 2.5f, 3, NULL);
    scene3d_free(&scene);
}

Test(molecule, pdb_takes_one_of_the_alternate_locations)
{
    // Which atoms of two residues are drawn: atoms have a letter as their name and one as their
    // location, or "." for none; a digit begins a residue.
    static const struct {
        const char *atoms;
        int n_expected;
    } CASES[] = {
        {"1C.N.", 2},         {"1CACB", 1},      {"1CBCANB", 2},   {"1C.NANBO.", 3},
        {"1CACB2CBCA", 2},    {"1CANA2CB", 3},   {"1C.C.C.", 3},   {"1CACA", 2},
        {"1C.CB", 1},         {"1CBC.", 1},      {"1C.CBN.NB", 2}, {"1C.CBNANB", 2},
        {"1N.C.O.NBCBOB", 3}, {"1C.CB2C.CB", 2}, {"1C.CACB", 1},   {"1CACBC.", 1},
    };
    for (size_t i = 0; i < sizeof CASES / sizeof CASES[0]; i++) {
        char text[2048] = "";
        int residue = 0;
        for (const char *c = CASES[i].atoms; *c != '\0'; c++) {
            if (*c >= '1' && *c <= '9') {
                residue = *c - '0';
            } else {
                const char name[] = {' ', *c, ' ', ' ', '\0'};
                c++;
                strcat(text, record("ATOM", name, *c == '.' ? ' ' : *c, residue, "C"));
            }
        }
        Scene3D scene = read_good(scene3d_read_pdb, text, "");
        cr_expect_eq(scene.n_spheres, CASES[i].n_expected, "%s: %d", CASES[i].atoms,
                     scene.n_spheres);
        scene3d_free(&scene);
    }
}

// Where a file was cut there is a fault, a warning, or nothing that is missed.
Test(molecule, a_cut_pdb_file_is_never_taken_in_silence)
{
    static const char LINE[] =
        "ATOM      2  CA  ALA A   1      -1.000   2.500   3.125  1.00  0.00           C";
    static const char ENDING[] =
        "molecule: warning: the last line (2) has no line end: if the file "
        "was cut there, its last number is wrong\n";
    for (size_t length = 1; length <= strlen(LINE); length++) {
        char text[256], fault[96];
        snprintf(text, sizeof text, CA_ATOM "%.*s", (int)length, LINE);
        if (length < 54 && LINE[length - 1] == ' ') {
            Scene3D scene;
            capture_begin(2);
            cr_expect_eq(read_text(scene3d_read_pdb, text, strlen(text), &scene), -1);
            expect_one_message(capture_end(2), "molecule:2: ");
            continue;
        }
        if (length < 54) {
            snprintf(
                fault, sizeof fault,
                "2: found the end of the file in column %zu, expected x, y and z up to column 54",
                length);
            expect_fault(scene3d_read_pdb, text, strlen(text),
                         length < 4 ? "2: found the end of the file in the name of a record, "
                                      "expected a whole record"
                                    : fault);
            continue;
        }
        Scene3D scene = read_good(scene3d_read_pdb, text, LINE[length - 1] == ' ' ? "" : ENDING);
        expect_atom(&scene, 1, -1, 2.5f, 3.125f, "C");
        scene3d_free(&scene);
    }
    expect_fault(scene3d_read_pdb, TEXT(CA_ATOM "HETA"),
                 "2: found the end of the file in the name of a record, expected a whole record");
    Scene3D scene = read_good(scene3d_read_pdb, CA_ATOM "END", "");  // nothing can be missing
    scene3d_free(&scene);
}

Test(molecule, a_pdb_file_cut_within_its_last_record_says_so)
{
    static const char *const ENDS[] = {"E", "EN", "ENDM", "ENDMD"};
    for (size_t i = 0; i < sizeof ENDS / sizeof ENDS[0]; i++) {
        char text[256];
        snprintf(text, sizeof text, CA_ATOM "%s", ENDS[i]);
        Scene3D scene = read_good(scene3d_read_pdb, text,
                                  "molecule: warning: the file ends too soon, within the name of a "
                                  "record in line 2\n");
        scene3d_free(&scene);
    }
    Scene3D scene = read_good(
        scene3d_read_pdb, "HETATM    1 XX   UNK A   1       1.000   2.000   3.000\nEN",
        "molecule: warning: drew 1 atom of unknown elements in pink: \"XX\"; the file ends too "
        "soon, within the name of a record in line 2\n");
    scene3d_free(&scene);
}

Test(molecule, pdb_faults)
{
    static const struct {
        const char *text;
        size_t length;
        const char *fault;
    } CASES[] = {
        {TEXT(""), "1: found no atoms, expected at least one"},
        {TEXT("HEADER\nEND\n" CA_ATOM), "2: found no atoms, expected at least one"},
        {TEXT("MODEL 1\nENDMDL\n" CA_ATOM), "2: found no atoms, expected at least one"},
        {TEXT("b 0 0 0\nv\n"), "3: found no atoms, expected at least one"},
        {TEXT("ATOM\n"), "1: x: found \"\", expected a finite number"},
        {TEXT(CA_ATOM "ATOM      2  CA  ALA A   1      -1.000   2.500\n"),
         "2: z: found \"\", expected a finite number"},
        {TEXT("ATOM      2  CA  ALA A   1   -1.000   2.500   3.000\n"),
         "1: columns 28 to 30: found \"-\", expected blanks before x"},
        {TEXT("ATOM      2  CA  ALA A   1      abc     2.500   3.000\n"),
         "1: x: found \"abc\", expected a finite number"},
        {TEXT("ATOM      2  CA  ALA A   1      -1.000     NaN   3.000\n"),
         "1: y: found \"NaN\", expected a finite number"},
        {TEXT("ATOM      2  CA  ALA A   1      -1.000     1e7   3.000\n"),
         "1: y: found \"1e7\", expected a number from -1000000 to 1000000"},
        {TEXT("ATOM      2  CA  ALA A   1      -1.000   2.500 \t 3.000\n"),
         "1: z: found \"? 3.000\", expected a finite number"},
        {TEXT(CA_ATOM "REMARK \0\n"), "2: found a NUL byte, expected text"},
    };
    for (size_t i = 0; i < sizeof CASES / sizeof CASES[0]; i++) {
        expect_fault(scene3d_read_pdb, CASES[i].text, CASES[i].length, CASES[i].fault);
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
        for (size_t length = 0; length <= strlen(FILES[i].text); length++) {
            Scene3D scene;
            capture_begin(2);
            int result = read_text(FILES[i].read, FILES[i].text, length, &scene);
            const char *message = capture_end(2);
            if (result != 0 || message[0] != '\0') {
                expect_one_message(message, result == 0 ? "molecule: warning: " : "molecule:");
            }
            scene3d_free(&scene);
        }
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
