// Writing the answers for other programs (see copies_export.h):
//
//     OUTPUT/copies-names.csv                 number, id, name: for the instructor alone
//     OUTPUT/copies-export/answers/001/answers.c
//     OUTPUT/copies-export/base/answers.c     what everybody was given
//     OUTPUT/copies-export/info.csv           a list of the files, for Dolos
//
// An answer is wrapped in a function without parameters, as these programs read C and no OpenCL.
#include "copies_export.h"

#include "complain.h"
#include "csv_cell.h"
#include "folder.h"
#include "holes.h"
#include "output_file.h"
#include "path.h"
#include "skeleton.h"

#include <ctype.h>
#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

static int machine_fault(const char *path)
{
    complain("copies: %s: %s", path, strerror(errno));
    return -1;
}

static int folder_make(const char *path)
{
    return mkdir(path, 0770) == 0 ? 0 : machine_fault(path);
}

int other_tool_find(const char *name, OtherTool *tool)
{
    static const char *const names[] = {
        [OTHER_JPLAG] = "jplag", [OTHER_DOLOS] = "dolos", [OTHER_MOSS] = "moss"};
    for (int i = 0; i < (int)(sizeof names / sizeof *names); i++) {
        if (strcmp(names[i], name) == 0) {
            *tool = (OtherTool)i;
            return 0;
        }
    }
    return -1;
}

// ---- Answers ---------------------------------------------------------------------------------

static void function_write(FILE *file, const char *task, const char *answer)
{
    fputs("void ", file);
    for (; *task != '\0'; task++) {
        fputc(isalnum((unsigned char)*task) ? *task : '_', file);
    }
    fprintf(file, "(void)\n{\n%s}\n\n", answer != NULL ? answer : "");
}

static int author_write(const Alike *alike, const char *folder, int number)
{
    const Manifest *manifest = &alike->class.manifest;
    const Author *author = &alike->class.authors[number - 1];
    char path[PATH_MAX];
    OutputFile output;
    path_make(path, "%s/answers/%03d", folder, number);
    if (folder_make(path) != 0) {
        return -1;
    }
    path_make(path, "%s/answers/%03d/answers.c", folder, number);
    if (output_file_open(&output, path) != 0) {
        return -1;
    }
    for (int i = 0; i < manifest->n_tasks; i++) {
        function_write(output.file, manifest->tasks[i].id, author->answers[i].text);
    }
    return output_file_commit(&output);
}

static int base_write(const Alike *alike, const char *folder)
{
    const Manifest *manifest = &alike->class.manifest;
    char path[PATH_MAX];
    OutputFile output;
    path_make(path, "%s/base/answers.c", folder);
    if (output_file_open(&output, path) != 0) {
        return -1;
    }
    for (int i = 0; i < manifest->n_tasks; i++) {
        char *skeleton = skeleton_read(manifest, manifest->tasks[i].file);
        char *hole = skeleton != NULL ? hole_read(skeleton, manifest->tasks[i].id) : NULL;
        function_write(output.file, manifest->tasks[i].id, hole);
        free(skeleton), free(hole);
    }
    return output_file_commit(&output);
}

// ---- Lists -----------------------------------------------------------------------------------

static int info_write(const Alike *alike, const char *folder)
{
    char path[PATH_MAX];
    OutputFile output;
    path_make(path, "%s/info.csv", folder);
    if (output_file_open(&output, path) != 0) {
        return -1;
    }
    fputs("filename,full_name\n", output.file);
    for (int i = 1; i <= alike->class.n_authors; i++) {
        fprintf(output.file, "answers/%03d/answers.c,%03d\n", i, i);
    }
    return output_file_commit(&output);
}

static int names_write(const Alike *alike, const char *folder)
{
    char path[PATH_MAX];
    OutputFile output;
    path_make(path, "%s/copies-names.csv", folder);
    if (output_file_open(&output, path) != 0) {
        return -1;
    }
    fputs("\"number\",\"id\",\"name\"\n", output.file);
    for (int i = 0; i < alike->class.n_authors; i++) {
        const Entrant *entrant = alike->class.authors[i].entrant;
        fprintf(output.file, "\"%03d\",\"%s\",", i + 1, entrant->slug);
        csv_cell_write(output.file, entrant->label);
        fputs("\n", output.file);
    }
    return output_file_commit(&output);
}

// ---- All -------------------------------------------------------------------------------------

int copies_export(const Alike *alike, const char *output)
{
    char folder[PATH_MAX], answers[PATH_MAX], base[PATH_MAX];
    path_make(folder, "%s/copies-export", output);
    path_make(answers, "%s/answers", folder);
    path_make(base, "%s/base", folder);
    if (folder_remove(folder) != 0 && errno != ENOENT) {
        return machine_fault(folder);
    }
    int result = folder_make(folder) | folder_make(answers) | folder_make(base);
    for (int i = 1; result == 0 && i <= alike->class.n_authors; i++) {
        result = author_write(alike, folder, i);
    }
    return result == 0
               ? base_write(alike, folder) | info_write(alike, folder) | names_write(alike, output)
               : -1;
}

void copies_export_print(const char *output, OtherTool tool)
{
    static const char *const calls[] = {
        [OTHER_JPLAG] = "java -jar jplag.jar -l cpp -p .c -t 5 -bc base answers",
        [OTHER_DOLOS] = "dolos run -l c -k 8 -w 4 --ignore base/answers.c info.csv",
        [OTHER_MOSS] = "perl moss.pl -l c -d -b base/answers.c answers/*/answers.c",
    };
    printf("Answers under numbers: %s/copies-export (names: %s/copies-names.csv). Run in that "
           "folder:\n    %s\n",
           output, output, calls[tool]);
    if (tool == OTHER_MOSS) {
        printf("MOSS runs at Stanford University. It gets all answers, with their comments, under "
               "numbers.\n");
    }
}
