// known: the known answers of a lab (tests/known/README.md) on the command line, for scripts.
//
//     known list LAB               a line for each: wrong or right, name, task, its file, check
//     known read LAB NAME          print its text
//     known put LAB NAME FOLDER    put it into its hole, in the file of this folder
#include "complain.h"
#include "holes.h"
#include "known_answer.h"
#include "output_file.h"
#include "path.h"
#include "text_file.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int list(const KnownAnswers *answers)
{
    for (int i = 0; i < answers->n; i++) {
        const KnownAnswer *answer = &answers->all[i];
        printf("%s %s %s %s %s\n", answer->is_right ? "right" : "wrong", answer->name,
               answer->task->id, answer->task->file, answer->is_right ? "-" : answer->check);
    }
    return EXIT_SUCCESS;
}

static int put(const KnownAnswer *answer, const char *folder)
{
    char path[PATH_MAX];
    path_make(path, "%s/%s", folder, answer->task->file);
    char *text = text_file_read(path);
    char *filled = text != NULL ? hole_fill(text, answer->task->id, answer->text) : NULL;
    OutputFile output;
    int status = EXIT_FAILURE;
    if (text != NULL && filled == NULL) {
        complain("%s: no task called %s", path, answer->task->id);
    } else if (filled != NULL && output_file_open(&output, path) == 0) {
        fputs(filled, output.file);
        status = output_file_commit(&output) == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
    }
    free(text);
    free(filled);
    return status;
}

// Do as the words behind the lab say with the answer that they name.
static int use(KnownAnswers *answers, const char *lab, const char *name, const char *folder)
{
    const KnownAnswer *answer = known_answers_find(answers, name);
    if (answer == NULL) {
        complain("known: " KNOWN_FOLDER "/%s: found no answer called %s", lab, name);
        return EXIT_FAILURE;
    }
    return folder != NULL ? put(answer, folder)
                          : (fputs(answer->text, stdout) < 0 ? EXIT_FAILURE : EXIT_SUCCESS);
}

int main(int argc, char **argv)
{
    static KnownAnswers answers;
    Manifest manifest;
    const int is_list = argc == 3 && strcmp(argv[1], "list") == 0;
    const int is_read = argc == 4 && strcmp(argv[1], "read") == 0;
    const int is_put = argc == 5 && strcmp(argv[1], "put") == 0;
    if (!is_list && !is_read && !is_put) {
        fprintf(stderr,
                "usage: known list LAB | known read LAB NAME | known put LAB NAME FOLDER\n");
        return EXIT_FAILURE;
    }
    if (manifest_load("solutions", argv[2], &manifest) != 0) {
        return EXIT_FAILURE;
    }
    int status = EXIT_FAILURE;
    if (known_answers_read(&answers, &manifest) == 0) {
        status =
            is_list ? list(&answers) : use(&answers, argv[2], argv[3], is_put ? argv[4] : NULL);
    }
    known_answers_free(&answers);
    manifest_free(&manifest);
    return status;
}
