// common/options: the command line of every lab.
#include "options.h"
#include "surroundings.h"

#define MAX_WORDS 8

static void enter(void)
{
    folder_enter();
    mkdir("kernels", 0777);  // looks like a course
    mkdir("labs", 0777);
}

TestSuite(options, .init = enter, .fini = folder_leave);

// Parse a command line given as words, NULL after the last.
static OptionsResult parse(const char *const words[MAX_WORDS], int set, Options *options)
{
    // getopt_long() reorders the array, so it gets one of its own.
    char *argv[MAX_WORDS + 2] = {(char *)"program"};
    int argc = 1;
    for (int i = 0; i < MAX_WORDS && words[i] != NULL; i++) {
        argv[argc++] = (char *)words[i];
    }
    return options_parse(argc, argv, "01-naive-2d", "Draws circles.", set, options);
}

Test(options, defaults)
{
    Options options;
    cr_assert_eq(parse((const char *[MAX_WORDS]){NULL}, OPTIONS_SCENE, &options), OPTIONS_RUN);
    cr_expect_str_eq(options.scene, "random");
    cr_expect(options.width == 0 && options.height == 0);
    cr_expect_str_eq(options.output, "build/01-naive-2d.png");
    cr_expect_null(options.device);
    cr_expect_null(options.stats);
    cr_expect_eq(options.n_frames, 1);
    cr_expect(options.pixel_x == -1 && options.pixel_y == -1, "no pixel is followed");
    cr_expect_eq(options.max_depth, OPTIONS_DEFAULT_MAX_DEPTH);
    cr_expect_eq(options.leaf_size, OPTIONS_DEFAULT_LEAF_SIZE);
    cr_expect_eq(access("build", W_OK), 0, "the default's folder is made");
}

Test(options, everything_given)
{
    Options options;
    const char *first[MAX_WORDS] = {"--scene=a.csv", "--size", "640x480", "--output=p.exr",
                                    "--frames",      "7",      "--stats", "s.json"};
    cr_assert_eq(parse(first, OPTIONS_SCENE, &options), OPTIONS_RUN);
    cr_expect_str_eq(options.scene, "a.csv");
    cr_expect(options.width == 640 && options.height == 480);
    cr_expect_str_eq(options.output, "p.exr");
    cr_expect_eq(options.n_frames, 7);
    cr_expect_str_eq(options.stats, "s.json");
    cr_expect_eq(folder_count(), 2, "nothing is made when --output is given");

    const char *pixel[MAX_WORDS] = {"--pixel=0,479", "--json=s.json", "--svg=s.svg"};
    cr_assert_eq(parse(pixel, OPTIONS_PIXEL, &options), OPTIONS_RUN);
    cr_expect(options.pixel_x == 0 && options.pixel_y == 479);
    cr_expect_str_eq(options.json, "s.json");
    cr_expect_str_eq(options.svg, "s.svg");

    const char *second[MAX_WORDS] = {"--device", "pocl", "--max-depth=64", "--leaf-size=1",
                                     "--size=1x1000000"};
    cr_assert_eq(parse(second, OPTIONS_TREE, &options), OPTIONS_RUN);
    cr_expect_str_eq(options.device, "pocl");
    cr_expect_eq(options.max_depth, OPTIONS_LARGEST_MAX_DEPTH);
    cr_expect_eq(options.leaf_size, 1);
    cr_expect_eq(options.height, 1000000);
}

#define NAME_64 "a-name-of-which-four-are-a-byte-longer-than-a-name-may-be-------"

static const struct {
    const char *words[MAX_WORDS];
    const char *message;
} BAD[] = {
    {{"--size", "640"}, "expected WxH"},
    {{"--size", "640x"}, "expected WxH"},
    {{"--size", "x480"}, "expected WxH"},
    {{"--size", "0x480"}, "expected WxH"},
    {{"--size", "-3x480"}, "expected WxH"},
    {{"--size", "640x480x2"}, "expected WxH"},
    {{"--size", "640X480"}, "expected WxH"},
    {{"--size", " 640x480"}, "expected WxH"},
    {{"--pixel", "7"}, "expected X,Y"},
    {{"--pixel", "7x7"}, "expected X,Y"},
    {{"--pixel", "7,-1"}, "expected X,Y, two whole numbers from 0"},
    {{"--pixel", "7,7,7"}, "expected X,Y"},
    {{"--size", "1000001x1"}, "1000000"},
    {{"--size", "99999999999999999999x1"}, "expected WxH"},
    {{"--frames", "0"}, "--frames: found \"0\""},
    {{"--frames", "-1"}, "--frames"},
    {{"--frames", "1.5"}, "--frames"},
    {{"--frames", ""}, "--frames"},
    {{"--frames", "99999999999999999999"}, "--frames"},
    {{"--max-depth", "0"}, "from 1 to 64"},
    {{"--max-depth", "65"}, "from 1 to 64"},
    {{"--leaf-size", "0"}, "--leaf-size"},
    {{"--leaf-size", "few"}, "found \"few\""},
    {{"--output", "picture.jpg"}, ".png or .exr"},
    {{"--output", "picture"}, ".png or .exr"},
    {{"--output", ".png"}, ".png or .exr"},
    {{"--output", "folder.png/.exr"}, ".png or .exr"},
    {{"--output", "nowhere/p.png"}, "folder that exists"},
    {{"--output", "file/p.png"}, "folder that exists"},
    {{"--output", "folder.png"}, "not a folder"},
    {{"--output", "full.png"}, "a regular file"},
    {{"--stats", "nowhere/s.json"}, "folder that exists"},
    {{"--stats", "folder.png"}, "not a folder"},
    {{"--stats", "/dev/full"}, "a regular file"},
    {{"--output", "p.png", "--stats", "p.png"}, "--stats: found \"p.png\", expected another file"},
    {{"--output", "there.png", "--stats", "./there.png"}, "another file than --output"},
    {{"--output", "labs/p.png", "--stats", "labs/../labs//p.png"}, "another file than --output"},
    {{"--output", "linked/p.png", "--stats", "labs/p.png"}, "another file than --output"},
    {{"--stats", "build/01-naive-2d.png"}, "another file than --output"},
    {{"--stats", NAME_64 NAME_64 NAME_64 NAME_64}, "a shorter path"},
    {{"--scene"}, "--scene needs an argument"},
    {{"--colour", "red"}, "--colour"},
    {{"--colour=red"}, ": --colour=red is no option here"},
    {{"-x"}, ": -x is no option here"},
    {{"-xy"}, ": -x is no option here"},
    {{"--size=8x8", "-xy", "stray"}, ": -x is no option here"},
    {{"--s", "640x480"}, ": --s is short for more than one option"},
    {{"--s=640x480"}, ": --s=640x480 is short for more than one option"},
    {{"--siz"}, ": --size needs an argument"},
    {{"stray"}, "stray word \"stray\""},
    {{"--frames", "2", "stray"}, "stray word \"stray\""},
    {{"--help=me"}, ": --help does not take an argument"},
    {{"--list=all"}, ": --list-devices does not take an argument"},
};

Test(options, bad_words_give_one_message)
{
    file_write("file", "", 0);
    file_write("there.png", "", 0);
    mkdir("folder.png", 0777);
    cr_assert_eq(symlink("labs", "linked"), 0);
    cr_assert_eq(symlink("/dev/full", "full.png"), 0);
    for (size_t i = 0; i < sizeof BAD / sizeof BAD[0]; i++) {
        Options options;
        capture_begin(2);
        OptionsResult result = parse(BAD[i].words, OPTIONS_SCENE | OPTIONS_TREE, &options);
        const char *message = capture_end(2);
        expect_one_message(message, BAD[i].message);
        expect_one_message(message, "01-naive-2d: ");
        expect_one_message(message, "(try --help)");
        cr_expect_eq(result, OPTIONS_BAD, "case %zu, %s, was taken", i, BAD[i].words[0]);
    }
}

Test(options, figures_beside_the_picture_are_another_file)
{
    Options options;
    const char *const names[MAX_WORDS] = {"--output=p.png", "--stats=labs/p.png"};
    cr_expect_eq(parse(names, OPTIONS_SCENE, &options), OPTIONS_RUN);
    // A link's place is taken by what is saved, and what it led to stays.
    file_write("p.png", "", 0);
    cr_assert_eq(symlink("p.png", "link.json"), 0);
    const char *const link[MAX_WORDS] = {"--output=p.png", "--stats=link.json"};
    cr_expect_eq(parse(link, OPTIONS_SCENE, &options), OPTIONS_RUN);
}

// The superuser may write anywhere, so this can only be seen as another user.
Test(options, a_folder_without_rights)
{
    if (geteuid() == 0) {
        SKIP_TEST("the superuser may write anywhere");
    }
    mkdir("locked", 0555);
    Options options;
    capture_begin(2);
    OptionsResult result = parse((const char *[MAX_WORDS]){"--output=locked/p.png"}, 0, &options);
    expect_one_message(capture_end(2), "can be written");
    cr_expect_eq(result, OPTIONS_BAD);
}

Test(options, a_lab_takes_and_notes_what_it_does_not_use)
{
    static const char *const FOREIGN[][MAX_WORDS] = {
        {"--scene", "example"}, {"--max-depth", "3"}, {"--leaf-size", "3"}, {"--device", "0"}};
    for (size_t i = 0; i < sizeof FOREIGN / sizeof FOREIGN[0]; i++) {
        Options options;
        char note[64];
        snprintf(note, sizeof note, "01-naive-2d: %s is not used in this lab\n", FOREIGN[i][0]);
        capture_begin(2);
        OptionsResult result = parse(FOREIGN[i], 0, &options);
        expect_one_message(capture_end(2), note);
        cr_expect_eq(result, OPTIONS_RUN);

        capture_begin(2);
        result = parse(FOREIGN[i], OPTIONS_SCENE | OPTIONS_TREE | OPTIONS_DEVICE, &options);
        cr_expect_str_eq(capture_end(2), "", "a note on %s where it is used", FOREIGN[i][0]);
        cr_expect_eq(result, OPTIONS_RUN);
    }
}

Test(options, what_is_not_used_is_noted_once_and_still_checked)
{
    Options options;
    capture_begin(2);
    OptionsResult result = parse((const char *[MAX_WORDS]){"--scene=a", "--scene=b"}, 0, &options);
    expect_one_message(capture_end(2), "--scene is not used");
    cr_expect_eq(result, OPTIONS_RUN);

    // A fault is told alone, also when it comes after such an option.
    static const char *const BAD_WORDS[][MAX_WORDS] = {
        {"--scene=a", "--max-depth=0"}, {"--scene=a", "--output=a.gif"}, {"--scene=a", "stray"}};
    for (size_t i = 0; i < sizeof BAD_WORDS / sizeof BAD_WORDS[0]; i++) {
        cr_expect_eq(WITH_MESSAGE("(try --help)", parse(BAD_WORDS[i], 0, &options)), OPTIONS_BAD);
    }
}

Test(options, help_names_what_the_lab_understands)
{
    Options options;
    capture_begin(1);
    OptionsResult result = parse((const char *[MAX_WORDS]){"--help"}, OPTIONS_SCENE, &options);
    const char *help = capture_end(1);
    cr_expect_eq(result, OPTIONS_DONE);
    static const char *const PARTS[] = {"Draws circles.", "--scene", "equal-depths", "--frames",
                                        "build/01-naive-2d.png"};
    for (size_t i = 0; i < sizeof PARTS / sizeof PARTS[0]; i++) {
        cr_expect_not_null(strstr(help, PARTS[i]), "no %s", PARTS[i]);
    }
    cr_expect_null(strstr(help, "--max-depth"), "an option of labs with trees");
    cr_expect_eq(folder_count(), 2, "help makes no folder");
}

// Only a scene can have a size of its own.
Test(options, help_says_which_size_holds)
{
    Options options;
    capture_begin(1);
    parse((const char *[MAX_WORDS]){"--help"}, 0, &options);
    cr_expect_not_null(strstr(capture_end(1), "the picture's size in pixels (640x480)"));
    capture_begin(1);
    parse((const char *[MAX_WORDS]){"--help"}, OPTIONS_SCENE3D, &options);
    cr_expect_not_null(strstr(capture_end(1), "the picture's size in pixels (the scene's own)"));
}

Test(options, devices_are_listed)
{
    Options options;
    capture_begin(1);
    OptionsResult result = parse((const char *[MAX_WORDS]){"--list-devices"}, 0, &options);
    const char *list = capture_end(1);
    cr_expect_eq(result, OPTIONS_DONE);
    cr_expect_eq(strncmp(list, "0  ", 3), 0);
}

// The test's own program lies in a course's build folder, so it knows where to go.
Test(options, the_wrong_folder_is_told_and_left_as_it_was)
{
    rmdir("labs");
    Options options;
    capture_begin(2);
    OptionsResult result = parse((const char *[MAX_WORDS]){NULL}, OPTIONS_SCENE, &options);
    expect_one_message(capture_end(2), "01-naive-2d: started in the wrong folder, expected the "
                                       "course's top folder: cd '/");
    cr_expect_eq(result, OPTIONS_BAD);
    cr_expect_eq(folder_count(), 1, "it made something");
    mkdir("solutions", 0777);  // is a course, too
    cr_expect_eq(parse((const char *[MAX_WORDS]){NULL}, OPTIONS_SCENE, &options), OPTIONS_RUN);
}
