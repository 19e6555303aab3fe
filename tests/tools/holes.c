// holes: the holes of a solution on the command line, for the Makefile and the tests.
//
//     holes cut FILE                 print FILE with every hole replaced by its placeholder
//     holes list FILE                print the ids of its holes, one a line
//     holes read FILE TASK           print the content of its hole TASK
//     holes fill FILE TASK ANSWER    print FILE with hole TASK filled by file ANSWER
#include "holes.h"

#include "complain.h"
#include "text_file.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int list(const char *text)
{
    char id[HOLE_ID_BYTES];
    for (int i = 0; hole_id(text, i, id); i++) {
        puts(id);
    }
    return EXIT_SUCCESS;
}

// Print a text made by one of the hole functions and free it.
static int print(char *text)
{
    if (text == NULL) {
        return EXIT_FAILURE;
    }
    fputs(text, stdout);
    free(text);
    return fflush(stdout) == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}

static int print_hole(const char *text, const char *name, const char *task)
{
    char *content = hole_read(text, task);
    if (content == NULL) {
        complain("%s: the markers of task %s are not there once each", name, task);
    }
    return print(content);
}

static int fill(const char *solution, const char *name, const char *task, const char *answer_path)
{
    char *answer = text_file_read(answer_path);
    if (answer == NULL) {
        return EXIT_FAILURE;
    }
    char *filled = hole_fill(solution, task, answer);
    free(answer);
    if (filled == NULL) {
        complain("%s: no task called %s", name, task);
    }
    return print(filled);
}

int main(int argc, char **argv)
{
    const int is_fill = argc == 5 && strcmp(argv[1], "fill") == 0;
    const int is_read = argc == 4 && strcmp(argv[1], "read") == 0;
    const int is_cut = argc == 3 && strcmp(argv[1], "cut") == 0;
    const int is_list = argc == 3 && strcmp(argv[1], "list") == 0;
    if (!is_fill && !is_read && !is_cut && !is_list) {
        fprintf(stderr, "usage: holes cut FILE | holes list FILE | holes read FILE TASK | "
                        "holes fill FILE TASK ANSWER\n");
        return EXIT_FAILURE;
    }
    char *text = text_file_read(argv[2]);
    if (text == NULL) {
        return EXIT_FAILURE;
    }
    const int status = is_cut    ? print(holes_cut(text, argv[2]))
                       : is_list ? list(text)
                       : is_read ? print_hole(text, argv[2], argv[3])
                                 : fill(text, argv[2], argv[3], argv[4]);
    free(text);
    return status;
}
