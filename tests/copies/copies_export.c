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

// ---- Files -----------------------------------------------------------------------------------

// What a file holds; of an author's answers `number`, from 1.
typedef void FileWrite(FILE *file, const Alike *alike, int number);

static void answers_write(FILE *file, const Alike *alike, int number)
{
    const Manifest *manifest = &alike->class.manifest;
    for (int i = 0; i < manifest->n_tasks; i++) {
        function_write(file, manifest->tasks[i].id,
                       alike->class.authors[number - 1].answers[i].text);
    }
}

static void base_write(FILE *file, const Alike *alike, int number)
{
    const Manifest *manifest = &alike->class.manifest;
    (void)number;
    for (int i = 0; i < manifest->n_tasks; i++) {
        char *skeleton = skeleton_read(manifest, manifest->tasks[i].file);
        char *hole = skeleton != NULL ? hole_read(skeleton, manifest->tasks[i].id) : NULL;
        function_write(file, manifest->tasks[i].id, hole);
        free(skeleton), free(hole);
    }
}

static void info_write(FILE *file, const Alike *alike, int number)
{
    (void)number;
    fputs("filename,full_name\n", file);
    for (int i = 1; i <= alike->class.n_authors; i++) {
        fprintf(file, "answers/%03d/answers.c,%03d\n", i, i);
    }
}

static void names_write(FILE *file, const Alike *alike, int number)
{
    (void)number;
    fputs("\"number\",\"id\",\"name\"\n", file);
    for (int i = 0; i < alike->class.n_authors; i++) {
        const Entrant *entrant = alike->class.authors[i].entrant;
        fprintf(file, "\"%03d\",\"%s\",", i + 1, entrant->slug);
        csv_cell_write(file, entrant->label);
        fputs("\n", file);
    }
}

// Write a file, whose folder is there. Returns 0, or -1 after one message.
static int file_write(const Alike *alike, const char *path, FileWrite *write, int number)
{
    OutputFile output;
    if (output_file_open(&output, path) != 0) {
        return -1;
    }
    write(output.file, alike, number);
    return output_file_commit(&output);
}

// ---- All -------------------------------------------------------------------------------------

int copies_export(const Alike *alike, const char *output)
{
    static const char *const folders[] = {"copies-export", "copies-export/base",
                                          "copies-export/answers"};
    static const struct {
        const char *name;
        FileWrite *write;
    } files[] = {{"copies-export/info.csv", info_write},
                 {"copies-export/base/answers.c", base_write},
                 {"copies-names.csv", names_write}};
    char path[PATH_MAX];
    path_make(path, "%s/copies-export", output);
    int result = folder_remove(path) != 0 && errno != ENOENT ? machine_fault(path) : 0;
    for (size_t i = 0; result == 0 && i < sizeof folders / sizeof *folders; i++) {
        path_make(path, "%s/%s", output, folders[i]);
        result = folder_make(path);
    }
    for (size_t i = 0; result == 0 && i < sizeof files / sizeof *files; i++) {
        path_make(path, "%s/%s", output, files[i].name);
        result = file_write(alike, path, files[i].write, 0);
    }
    for (int i = 1; result == 0 && i <= alike->class.n_authors; i++) {
        path_make(path, "%s/copies-export/answers/%03d", output, i);
        result = folder_make(path);
        path_make(path, "%s/copies-export/answers/%03d/answers.c", output, i);
        result = result == 0 ? file_write(alike, path, answers_write, i) : -1;
    }
    return result;
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
