// common/molecule_pdb: PDB files, whatever the text may hold.
#include "molecule_samples.h"

TestSuite(molecule_pdb, .init = folder_enter, .fini = folder_leave);

// One record with parts of it changed: the name, the location, the residue, the element.
static const char *record_of(const char *kind, const char *name, char location, const char *residue,
                             int number, const char *element)
{
    static char line[128];
    snprintf(line, sizeof line,
             "%-6s    1 %-4s%c%-3s A%4d      -1.000   2.500   3.000  1.00  0.00  "
             "        %2s\n",
             kind, name, location, residue, number, element);
    return line;
}

static const char *record(const char *kind, const char *name, char location, int number,
                          const char *element)
{
    return record_of(kind, name, location, "LIG", number, element);
}

Test(molecule_pdb, pdb_is_read)
{
    static const char *const TEXTS[] = {
        CA_ATOM,
        "HEADER    WHATEVER\nREMARK 1 \xC3\xA4\n" CA_ATOM "TER\nEND\n",
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

Test(molecule_pdb, atoms_behind_the_first_model_are_counted)
{
    static const struct {
        const char *text, *warning;
    } CASES[] = {
        {"MODEL        1\n" CA_ATOM "ENDMDL\nMODEL        2\n" CA_ATOM "ENDMDL\nEND\n",
         "molecule: warning: left out 1 atom of other models\n"},
        {CA_ATOM "END\n" CA_ATOM CA_ATOM "END",
         "molecule: warning: left out 2 atoms of other models\n"},
        {CA_ATOM "END\nCONECT\nATOMS", ""},
    };
    for (size_t i = 0; i < sizeof CASES / sizeof CASES[0]; i++) {
        Scene3D scene = read_good(scene3d_read_pdb, CASES[i].text, CASES[i].warning);
        cr_expect_eq(scene.n_spheres, 1);
        scene3d_free(&scene);
    }
}

Test(molecule_pdb, pdb_columns_need_no_blanks_between)
{
    Scene3D scene = read_good(
        scene3d_read_pdb,
        "HETATM12345 FE   HEM A1234A   -999.123-999.4569999.999  1.00  0.00          FE\n", "");
    expect_atom(&scene, 0, -999.123f, -999.456f, 9999.999f, "Fe");
    scene3d_free(&scene);
}

Test(molecule_pdb, pdb_elements)
{
    static const struct {
        const char *kind, *name, *element;
        const char *expected;
    } CASES[] = {
        {"ATOM", " CA ", "C", "C"},   {"HETATM", "CA  ", "CA", "Ca"}, {"ATOM", " CA ", "", "C"},
        {"HETATM", "CA  ", "", "C"},  {"ATOM", "CA  ", "", "C"},      {"HETATM", " CA ", "", "C"},
        {"HETATM", "CE  ", "", "C"},  {"HETATM", "CD1 ", "", "C"},    {"HETATM", "NE2 ", "", "N"},
        {"HETATM", "SE  ", "", "Se"}, {"HETATM", "OXT ", "", "O"},    {"HETATM", "HE1 ", "", "H"},
        {"HETATM", "1HG ", "", "H"},  {"HETATM", " Br1", "", "Br"},   {"ATOM", " Cl ", "", "Cl"},
        {"ATOM", " Cb ", "", "C"},    {"HETATM", "FE  ", "", "Fe"},   {"HETATM", "FE1 ", "", "Fe"},
        {"ATOM", "HG11", "", "H"},    {"HETATM", "HG11", "", "H"},    {"HETATM", "HG  ", "", "Hg"},
        {"ATOM", "1HB ", "", "H"},    {"HETATM", "1H  ", "", "H"},    {"HETATM", "HO5'", "", "H"},
        {"HETATM", "C12A", "", "C"},  {"HETATM", "CL12", "", "Cl"},   {"ATOM", " N  ", "N", "N"},
        {"ATOM", " D  ", "D", "H"},   {"HETATM", " X  ", "zn", "Zn"}, {"HETATM", " O  ", "O1", "O"},
        {"ATOM", " O  ", "12", "O"},
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

// Where no column says an element, a residue may: an ion is all of its own.
Test(molecule_pdb, an_ion_is_known_by_its_residue)
{
    static const struct {
        const char *kind, *name, *residue;
        const char *expected;
    } CASES[] = {
        {"HETATM", "CA  ", "CA", "Ca"},  {"ATOM", "CA  ", "CA", "Ca"},
        {"HETATM", " CA ", "CA", "Ca"},  {"HETATM", "CA  ", "CA2", "Ca"},
        {"HETATM", "CA  ", "CAS", "C"},  {"HETATM", "CE  ", "MSE", "C"},
        {"HETATM", "CE  ", "CE", "Ce"},  {"ATOM", " ZN ", "ZN", "Zn"},
        {"ATOM", "CLA ", "CLA", "Cl"},   {"ATOM", " C  ", "C", "C"},
        {"HETATM", "FE  ", "HEM", "Fe"}, {"HETATM", "ND  ", "HEM", "N"},
    };
    for (size_t i = 0; i < sizeof CASES / sizeof CASES[0]; i++) {
        Scene3D scene =
            read_good(scene3d_read_pdb,
                      record_of(CASES[i].kind, CASES[i].name, ' ', CASES[i].residue, 1, ""), "");
        expect_atom(&scene, 0, -1, 2.5f, 3, CASES[i].expected);
        scene3d_free(&scene);
    }
}

// Names of four signs a column too far to the right: the last sign is no alternate location.
Test(molecule_pdb, shifted_names_of_four_signs_lose_no_atom)
{
    static const struct {
        const char *names[4];  // columns 13 to 16; 17 counts from '1', or from 'A'
        char first;
        const char *occupancy;
        int n_expected;
        const char *expected;
    } CASES[] = {
        {{" Br1", " Br1", " Br1", " Br1"}, '1', "  1.00", 4, "Br"},
        {{" HG1", " HG1", " HG1", " HG2"}, '1', "  1.00", 4, "H"},
        {{" HG1", " HG1", " HG1", " HG2"}, '1', "", 4, "H"},
        {{" HG1", " HG1", " HG1", " HG2"}, '1', "  0.00", 4, "H"},
        {{" C10", " C10", " C10", " C11"}, 'A', "  1.00", 4, "C"},
        {{" CL1", " CL1", " CL1", " CL1"}, '0', "  1.00", 4, "Cl"},
        {{" CG1", " CG1", " CG1", " CG1"}, '1', "  0.25", 1, "C"},
        {{" CG1", " CG1", " CG1", " CG1"}, 'A', "", 1, "C"},
        {{" CA ", " CA ", " CA ", " CA "}, '1', "  1.00", 1, "C"},
        {{"HG11", "HG11", "HG11", "HG11"}, 'A', "  1.00", 1, "H"},
    };
    for (size_t i = 0; i < sizeof CASES / sizeof CASES[0]; i++) {
        char text[512] = "";
        for (int atom = 0; atom < 4; atom++) {
            char line[128];
            snprintf(line, sizeof line, "HETATM    1 %s%cLIG A   1      -1.000   2.500   3.000%s\n",
                     CASES[i].names[atom], CASES[i].first + atom, CASES[i].occupancy);
            strcat(text, line);
        }
        Scene3D scene =
            read_good(scene3d_read_pdb, text,
                      CASES[i].n_expected == 4
                          ? ""
                          : "molecule: warning: left out 3 alternate locations of atoms\n");
        cr_expect_eq(scene.n_spheres, CASES[i].n_expected, "case %zu", i);
        expect_atom(&scene, 0, -1, 2.5f, 3, CASES[i].expected);
        scene3d_free(&scene);
    }
}

Test(molecule_pdb, pdb_takes_one_of_the_alternate_locations)
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
        int residue = 0, n_atoms = 0;
        for (const char *c = CASES[i].atoms; *c != '\0'; c++) {
            if (*c >= '1' && *c <= '9') {
                residue = *c - '0';
            } else {
                const char name[] = {' ', *c, ' ', ' ', '\0'};
                c++;
                n_atoms++;
                strcat(text, record("ATOM", name, *c == '.' ? ' ' : *c, residue, "C"));
            }
        }
        const int n_left_out = n_atoms - CASES[i].n_expected;
        char warning[96] = "";
        if (n_left_out > 0) {
            snprintf(warning, sizeof warning,
                     "molecule: warning: left out %d alternate location%s of atoms\n", n_left_out,
                     n_left_out == 1 ? "" : "s");
        }
        Scene3D scene = read_good(scene3d_read_pdb, text, warning);
        cr_expect_eq(scene.n_spheres, CASES[i].n_expected, "%s: %d", CASES[i].atoms,
                     scene.n_spheres);
        scene3d_free(&scene);
    }
}

// Where a file was cut there is a fault, a warning, or nothing that is missed.
Test(molecule_pdb, a_cut_pdb_file_is_never_taken_in_silence)
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
            cr_expect_eq(WITH_MESSAGE("molecule:2: ",
                                      read_text(scene3d_read_pdb, text, strlen(text), &scene)),
                         -1);
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

Test(molecule_pdb, a_pdb_file_cut_within_its_last_record_says_so)
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

Test(molecule_pdb, pdb_faults)
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
         "1: z: found \"\\x09 3.000\", expected a finite number"},
        {TEXT(CA_ATOM "REMARK \0\n"), "2: found a NUL byte, expected text"},
    };
    for (size_t i = 0; i < sizeof CASES / sizeof CASES[0]; i++) {
        expect_fault(scene3d_read_pdb, CASES[i].text, CASES[i].length, CASES[i].fault);
    }
}
