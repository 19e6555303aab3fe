// term: the gradebooks of several labs together.
//
//     term [--make] table [--pass POINTS] [--need N] [--excel] OUTPUT FOLDER...
//     term figures OUTPUT FOLDER...
//
// Each FOLDER is one that grade-class has written. `table` writes OUTPUT/term.csv and term.html,
// and prints what the instructor has to look at; with --make its options are make's PASS=, NEED=
// and EXCEL=. `figures` writes OUTPUT/class-figures.json, and prints which checks fail most often
// (term.h). Exit status: 0, or 2 after one message.
#include "clean_text.h"
#include "complain.h"
#include "option_table.h"
#include "path.h"
#include "term.h"

#include <errno.h>
#include <getopt.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

enum { EXIT_WRITTEN = 0, EXIT_FAULT = 2 };

static int usage(void)
{
    fputs("usage: term table [--pass POINTS] [--need N] [--excel] OUTPUT FOLDER...\n"
          "       term figures OUTPUT FOLDER...\n",
          stderr);
    return EXIT_FAULT;
}

typedef struct TermOptions {
    int pass, need, excel;
    int help;
} TermOptions;

// Whoever else has an account here has no business with others' marks.
static int output_make(const char *output)
{
    if (mkdir(output, 0770) != 0 && errno != EEXIST) {
        complain("term: %s: %s", output, strerror(errno));
        return -1;
    }
    return 0;
}

// One line for each lab, one for each row to look at, and what there is now.
static void summary_print(const Term *term, const char *csv, const char *page)
{
    for (int i = 0; i < term->n_labs; i++) {
        const TermCount count = term_count(term, i);
        printf("%s: %d with points, %d passed, mean %.1f of %d\n", term->labs[i].lab,
               count.n_scores, count.n_passed, count.mean, term->labs[i].max_score);
    }
    int n_admitted = 0;
    for (int p = 0; p < term->n_persons; p++) {
        const Person *person = &term->persons[p];
        n_admitted += term->need > 0 && strcmp(term_admission(term, person), "yes") == 0;
        if (person->note != NULL || person->n_open > 0) {
            char *note = term_note(term, person);
            char *name = line_clean(person->name);
            printf("look at \"%s\": %s\n", name, note != NULL ? note : "");
            free(name), free(note);
        }
    }
    printf("%d rows for %d labs", term->n_persons, term->n_labs);
    if (term->need > 0) {
        printf(", %d admitted (NEED=%d, PASS=%d)", n_admitted, term->need, term->pass);
    }
    printf(": see %s, %s\n", csv, page);
}

static int table_make(const TermOptions *options, const char *output, char *const *folders,
                      int n_folders)
{
    Term term;
    char csv[PATH_MAX], page[PATH_MAX];
    path_make(csv, "%s/term.csv", output);
    path_make(page, "%s/term.html", output);
    int failed = term_load(folders, n_folders, &term);
    if (!failed) {
        term.pass = options->pass;
        term.need = options->need;
        if (options->need > term.n_labs) {
            complain("term: NEED=%d, but CLASSES has %d labs: nobody can be admitted yet",
                     options->need, term.n_labs);
        }
        failed = term_join(&term) != 0 || output_make(output) != 0 ||
                 term_csv(&term, csv, options->excel) != 0 || term_page(&term, page) != 0;
    }
    if (!failed) {
        summary_print(&term, csv, page);
    }
    term_free(&term);
    return failed ? EXIT_FAULT : EXIT_WRITTEN;
}

static int figures_make(const char *output, char *const *folders, int n_folders)
{
    Term term;
    char path[PATH_MAX];
    path_make(path, "%s/class-figures.json", output);
    const int failed = term_load(folders, n_folders, &term) != 0 || output_make(output) != 0 ||
                       term_figures(&term, path) != 0;
    if (!failed) {
        printf("Figures without names: %s\n", path);
    }
    term_free(&term);
    return failed ? EXIT_FAULT : EXIT_WRITTEN;
}

#define PLACE(member) offsetof(TermOptions, member)

int main(int argc, char **argv)
{
    enum { N_ROWS = 4 };
    static const OptionRow rows[N_ROWS] = {
        {"pass", "POINTS", OPTION_NUMBER, PLACE(pass), 1, OPTION_LARGEST_NUMBER, 0, ""},
        {"need", "N", OPTION_NUMBER, PLACE(need), 1, TERM_MAX_LABS, 0, ""},
        {.name = "excel", .kind = OPTION_FLAG, .place = PLACE(excel)},
        {.name = "help", .kind = OPTION_ANSWER, .place = PLACE(help)},
    };
    const OptionTable table = {"term", rows, N_ROWS, 1, N_ROWS - 1};
    TermOptions options = {.pass = 50};
    const OptionsResult result = option_table_read(&table, argc, argv, &options, NULL);
    if (result != OPTIONS_RUN) {
        return result == OPTIONS_DONE ? usage() : EXIT_FAULT;
    }
    argv += optind, argc -= optind;
    if (argc >= 3 && strcmp(argv[0], "table") == 0) {
        return table_make(&options, argv[1], argv + 2, argc - 2);
    }
    if (argc >= 3 && strcmp(argv[0], "figures") == 0) {
        return figures_make(argv[1], argv + 2, argc - 2);
    }
    return usage();
}
