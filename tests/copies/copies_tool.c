// copies: which answers of a class are alike.
//
//     copies [--build BUILD] [--export jplag|dolos|moss] lab LAB FOLDER OUTPUT
//     copies [--build BUILD] term OUTPUT FOLDER...
//
// FOLDER has roster.json and submissions/SLUG, of a class that was graded, or only listed
// (gradebook roster). `lab` writes OUTPUT/copies.html and copies.json, and prints the first pairs.
// With --export the answers are also written for another tool (copies_export.h). `term` adds the
// pairs of several graded labs, and writes copies-term.html and copies-term.json. Exit status: 0,
// or 2 after one message. Read next: alike.h, copies_term.h.
#include "alike.h"
#include "clean_text.h"
#include "complain.h"
#include "copies_export.h"
#include "copies_term.h"
#include "hard.h"
#include "message.h"
#include "option_table.h"
#include "path.h"

#include <errno.h>
#include <getopt.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/stat.h>

enum { EXIT_WRITTEN = 0, EXIT_FAULT = 2 };

// So many pairs are printed.
enum { MOST_PRINTED = 10 };

// An accident with somebody's answer ends in one message before the machine is short of memory.
#define MOST_MEMORY ((rlim_t)2 << 30)

static void memory_limit(void)
{
    struct rlimit limit;
#ifndef __SANITIZE_ADDRESS__  // it needs more addresses than there is memory
    if (getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur > MOST_MEMORY) {
        limit.rlim_cur = MOST_MEMORY;  // what is started from here may need more, and set it
        setrlimit(RLIMIT_AS, &limit);
    }
#else
    (void)limit;
#endif
}

typedef struct CopiesOptions {
    const char *build, *export;
    int help;
} CopiesOptions;

static int usage(void)
{
    fputs("usage: copies [--build BUILD] [--export jplag|dolos|moss] lab LAB FOLDER OUTPUT\n"
          "       copies [--build BUILD] term OUTPUT FOLDER...\n",
          stderr);
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
    const int n_hard = hard_count(alike);
    if (n_hard > 0) {
        printf("hard to compare: %d author%s, see the page\n", n_hard, plural((unsigned)n_hard));
    }
    if (alike->class.n_unread > 0) {
        printf("cannot be read: %d of the submissions\n", alike->class.n_unread);
    }
    printf("%d authors, %d without an answer; %d pairs to look at: see %s\n",
           alike->class.n_authors, alike->class.n_without, pairs->n_listed, page);
}

static int lab_look(const CopiesOptions *options, const char *lab, const char *folder,
                    const char *output)
{
    Alike alike;
    char page[PATH_MAX], json[PATH_MAX];
    OtherTool tool = OTHER_JPLAG;
    if (options->export != NULL && other_tool_find(options->export, &tool) != 0) {
        complain("copies: --export: found \"%s\", expected jplag, dolos or moss", options->export);
        return EXIT_FAULT;
    }
    path_make(page, "%s/copies.html", output);
    path_make(json, "%s/copies.json", output);
    int failed = alike_read(options->build, lab, folder, &alike) != 0;
    alike.reports = output;
    failed = failed || copies_page(&alike, page) != 0 || copies_json(&alike, json) != 0 ||
             (options->export != NULL && copies_export(&alike, output) != 0);
    if (!failed) {
        summary_print(&alike, page);
        if (options->export != NULL) {
            copies_export_print(output, tool);
        }
    }
    alike_free(&alike);
    return failed ? EXIT_FAULT : EXIT_WRITTEN;
}

static void term_print(const AlikeTerm *all, const char *page)
{
    for (int i = 0; i < all->n_listed && i < MOST_PRINTED; i++) {
        const TermPair *pair = &all->pairs[i];
        char *first = line_clean(all->term.persons[pair->labs->first].name);
        char *second = line_clean(all->term.persons[pair->labs->second].name);
        printf("look at \"%s\" and \"%s\": %d lab%s, score %.1f\n", first, second, pair->n_labs,
               plural((unsigned)pair->n_labs), pair->score);
        free(first), free(second);
    }
    printf("%d persons, %d lab%s; %d pairs to look at: see %s\n", all->term.n_persons,
           all->term.n_labs, plural((unsigned)all->term.n_labs), all->n_listed, page);
}

static int term_look(const CopiesOptions *options, const char *output, char *const *folders,
                     int n_folders)
{
    AlikeTerm all;
    char page[PATH_MAX], json[PATH_MAX];
    path_make(page, "%s/copies-term.html", output);
    path_make(json, "%s/copies-term.json", output);
    int failed = alike_term_read(options->build, folders, n_folders, &all) != 0;
    // Whoever else has an account here has no business with others' answers.
    if (!failed && mkdir(output, 0770) != 0 && errno != EEXIST) {
        complain("copies: %s: %s", output, strerror(errno));
        failed = 1;
    }
    failed = failed || copies_term_page(&all, page) != 0 || copies_term_json(&all, json) != 0;
    if (!failed) {
        term_print(&all, page);
    }
    alike_term_free(&all);
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
    argv += optind, argc -= optind;
    memory_limit();
    if (argc == 4 && strcmp(argv[0], "lab") == 0) {
        return lab_look(&options, argv[1], argv[2], argv[3]);
    }
    if (argc >= 3 && strcmp(argv[0], "term") == 0) {
        return term_look(&options, argv[1], argv + 2, argc - 2);
    }
    return usage();
}
