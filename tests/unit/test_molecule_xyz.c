// common/molecule_xyz: XYZ files, whatever the text may hold.
#include "line_reader.h"
#include "molecule_samples.h"

TestSuite(molecule_xyz, .init = folder_enter, .fini = folder_leave);

Test(molecule_xyz, xyz_is_read)
{
    static const char *const TEXTS[] = {
        "2\nwater, a part of it\nO 0 0 0.5\nH 1 -2.5 3\n",
        "2\n\nO 0 0 0.5\nH 1 -2.5 3 ",
        "2\r\ncomment\r\nO 0 0 0.5\r\nH 1 -2.5 3\r\n\r\n",
        "\xEF\xBB\xBF 2 \n\no 0 0 0.5\nh 1 -2.5 3\n\n \n",
        "2\n\n8\t0\t0\t0.5\n 1   1 -2.5 3\n",
        "2\n\nO1 0 0 0.5 -0.8 charge\nH2 1 -25e-1 3. 0.4 # 1 2 3 4 5 6 7 8 9\n",
    };
    for (size_t i = 0; i < sizeof TEXTS / sizeof TEXTS[0]; i++) {
        Scene3D scene = read_good(scene3d_read_xyz, TEXTS[i], "");
        cr_assert_eq(scene.n_spheres, 2, "case %zu", i);
        expect_atom(&scene, 0, 0, 0, 0.5f, "O");
        expect_atom(&scene, 1, 1, -2.5f, 3, "H");
        scene3d_free(&scene);
    }
}

Test(molecule_xyz, frames_behind_the_first_are_counted)
{
    Scene3D scene =
        read_good(scene3d_read_xyz, "2\n\nO 0 0 0.5\nH 1 -2.5 3\n2\nthe next frame\nwhatever",
                  "molecule: warning: left out 3 lines of other frames\n");
    cr_expect_eq(scene.n_spheres, 2);
    scene3d_free(&scene);
}

// Extended XYZ: the comment says which columns there are. The last atom is always the same.
Test(molecule_xyz, properties_are_obeyed)
{
    static const char *const TEXTS[] = {
        "1\nProperties=species:S:1:pos:R:3\nH 1 -2.5 3\n",
        "1\nProperties=species:S:1:mass:R:1:pos:R:3\nH 1.008 1 -2.5 3\n",
        "1\nLattice=\"1 0 0\" Properties=pos:R:3:forces:R:3:species:S:1 pbc=\"T\"\n1 -2.5 3 7 8 9 "
        "H\n",
        "1\nProperties=\"id:I:1:Z:I:1:pos:R:3:tags:I:1\" energy=-1\r\n17 1 1 -2.5 3 0\r\n",
        "1\nProperties=Z:I:1:species:S:1:Z:I:1:pos:R:3\n6 H 7 1 -2.5 3\n",
    };
    for (size_t i = 0; i < sizeof TEXTS / sizeof TEXTS[0]; i++) {
        Scene3D scene = read_good(scene3d_read_xyz, TEXTS[i], "");
        cr_assert_eq(scene.n_spheres, 1, "case %zu", i);
        expect_atom(&scene, 0, 1, -2.5f, 3, "H");
        scene3d_free(&scene);
    }
}

// A comment may be longer than what is read of it, but for its properties.
Test(molecule_xyz, a_long_comment)
{
    static const char *const ENDS[] = {"", " PPropertiesProperties",
                                       " PProperties=species:S:1:pos:R:3",
                                       " and behind that Properties=species:S:1:pos:R:3"};
    for (size_t i = 0; i < sizeof ENDS / sizeof ENDS[0]; i++) {
        char *text;
        cr_assert_geq(asprintf(&text, "1\n%*s%s\nH 1 -2.5 3\n", LINE_MAX_LENGTH - 3, "x", ENDS[i]),
                      0);
        if (i < 2) {
            Scene3D scene = read_good(scene3d_read_xyz, text, "");
            expect_atom(&scene, 0, 1, -2.5f, 3, "H");
            scene3d_free(&scene);
        } else {
            expect_fault(scene3d_read_xyz, text, strlen(text),
                         "2: found \"Properties=\", expected it within the first 4096 characters");
        }
        free(text);
    }
}

Test(molecule_xyz, an_xyz_file_without_its_last_line_end_is_warned_of)
{
    Scene3D scene =
        read_good(scene3d_read_xyz, "2\n\nO 0 0 0.5\nH 1 -2.5 3",
                  "molecule: warning: the last line (4) has no line end: if the file was "
                  "cut there, its last number is wrong\n");
    expect_atom(&scene, 1, 1, -2.5f, 3, "H");
    scene3d_free(&scene);
}

Test(molecule_xyz, xyz_faults)
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
        {TEXT("1\nProperties=species:S:1:pos:R:2\nC 0 0\n"),
         "2: Properties=: found \"species:S:1:pos:R:2\", expected species:S:1 and pos:R:3 among "
         "its columns, at most 64 in all"},
        {TEXT("1\nProperties=pos:R:3\n0 0 0\n"),
         "2: Properties=: found \"pos:R:3\", expected species:S:1 and pos:R:3 among its columns, "
         "at most 64 in all"},
        {TEXT("1\nProperties=species:S:1:pos:R:3:a:R:61\n"),
         "2: Properties=: found \"species:S:1:pos:R:3:a:R:61\", expected species:S:1 and pos:R:3 "
         "among its columns, at most 64 in all"},
        {TEXT("1\nProperties=species:S:1:pos:R\nC 0 0 0\n"),
         "2: Properties=: found \"species:S:1:pos:R\", expected species:S:1 and pos:R:3 among its "
         "columns, at most 64 in all"},
        {TEXT("1\nProperties=species:S:1:mass:R:1:pos:R:3\nC 0 0 0\n"),
         "3: found 4 words, expected an element and its x, y and z"},
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
        {TEXT("1\n\nC x\033 y z\n"), "3: x: found \"x\\x1B\", expected a finite number"},
        {TEXT("1\n\nC 0 \0 0 0\n"), "3: found a NUL byte, expected text"},
        {TEXT("1\n\0\nC 0 0 0\n"), "2: found a NUL byte, expected text"},
    };
    for (size_t i = 0; i < sizeof CASES / sizeof CASES[0]; i++) {
        expect_fault(scene3d_read_xyz, CASES[i].text, CASES[i].length, CASES[i].fault);
    }
}

Test(molecule_xyz, unknown_elements_are_pink_and_named_once)
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
                      "\"X2\", \"X3\", \"X4\", \"\\x1B\" and others\n");
    scene3d_free(&scene);
}
