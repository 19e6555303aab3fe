// copies: which answers of a class are alike.
//
//     copies [--build BUILD] [--export jplag|dolos|moss] LAB FOLDER OUTPUT
//
// FOLDER has roster.json and submissions/SLUG, of a class that was graded, or only listed
// (gradebook roster). Writes OUTPUT/copies.html and copies.json, and prints the first pairs. With --export
// the answers are also written for another tool (copies_export.c). Exit status: 0, or 2 after one
// message. Read next: handed_in.h, forms.h, weights.h, pairs.h.
#include "alike.h"
#include "clean_text.h"
#include "complain.h"
#include "copies_export.h"
#include "option_table.h"
#include "path.h"

#include <getopt.h>
#include <stdio.h>
#include <stdlib.h>

enum { EXIT_WRITTEN = 0, EXIT_FAULT = 2 };

// So many pairs are printed.
enum { MOST_PRINTED = 10 };

typedef struct CopiesOptions {
    const char *build, *export;
    int help;
} CopiesOptions;

static int usage(void)
{
    fputs("usage: copies [--build BUILD] [--export jplag|dolos|moss] LAB FOLDER OUTPUT\n", stderr);
    return EXIT_FAULT;
}

static void pair_print(const Alike *alike, const Pair *pair)
{
    const Author *authors = alike->class.authors;
    char *first = line_clean(authors[pair->first].entrant->label);
    char *second = line_clean(authors[pair->second].entrant->label);
    printf("look at \"%s\" and \"%s\": %d forms that nobody else has, %d that both have, score "
           "%.1f\n",
           first, second, pair->n_only_two, pair->n_shared, pair->score);
    free(first), free(second);
}

static void summary_print(const Alike *alike, const char *page)
{
    const Pairs *pairs = &alike->pairs;
    for (int i = 0; i < pairs->n_listed && i < MOST_PRINTED; i++) {
        pair_print(alike, &pairs->all[i]);
    }
    if (pairs_are_too_few(&alike->class, pairs)) {
        printf("too short to tell: only %d of %d authors wrote enough that few others wrote\n",
               pairs->n_tellable, alike->class.n_authors);
    }
    printf("%d authors, %d without an answer; %d pairs to look at: see %s\n",
           alike->class.n_authors, alike->class.n_without, pairs->n_listed, page);
}

static int alike_write(const CopiesOptions *options, char **words)
{
    Alike alike = {.output = words[2]};
    char page[PATH_MAX], json[PATH_MAX];
    path_make(page, "%s/copies.html", alike.output);
    path_make(json, "%s/copies.json", alike.output);
    OtherTool tool = OTHER_JPLAG;
    if (options->export != NULL && other_tool_find(options->export, &tool) != 0) {
        complain("copies: --export: found \"%s\", expected jplag, dolos or moss", options->export);
        return EXIT_FAULT;
    }
    int failed = handed_in_read(options->build, words[0], words[1], &alike.class) != 0;
    if (!failed) {
        weights_make(&alike.class, &alike.weights);
        pairs_find(&alike.class, &alike.weights, &alike.pairs);
        failed = copies_page(&alike, page) != 0 || copies_json(&alike, json) != 0 ||
                 (options->export != NULL && copies_export(&alike) != 0);
    }
    if (!failed) {
        summary_print(&alike, page);
        if (options->export != NULL) {
            copies_export_print(&alike, tool);
        }
    }
    pairs_free(&alike.pairs);
    weights_free(&alike.weights);
    handed_in_free(&alike.class);
    return failed ? EXIT_FAULT : EXIT_WRITTEN;
}

#define PLACE(member) offsetof(CopiesOptions, member)

int main(int argc, char **argv)
{
    enum { N_ROWS = 3 };
    static const OptionRow rows[N_ROWS] = {
        {.name = "build", .argument = "BUILD", .place = PLACE(build)},
        {.name = "export", .argument = "TOOL", .place = PLACE(export)},
        {.name = "help", .kind = OPTION_ANSWER, .place = PLACE(help)},
    };
    const OptionTable table = {"copies", rows, N_ROWS, .takes_words = 1};
    CopiesOptions options = {.build = "build"};
    const OptionsResult result = option_table_read(&table, argc, argv, &options, NULL);
    if (result != OPTIONS_RUN) {
        return result == OPTIONS_DONE ? usage() : EXIT_FAULT;
    }
    return argc - optind == 3 ? alike_write(&options, argv + optind) : usage();
}
