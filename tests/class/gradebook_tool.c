// gradebook: from a folder of submissions to a roster, and from graded submissions to a gradebook.
//
// What each command takes is in usage().
//
// `unpack` unpacks an export into the empty FOLDER, in the sandbox, and prints the folder below it
// that holds the submissions; `roster` writes FOLDER/roster.json and a link
// FOLDER/submissions/SLUG to each entry, with `--commits` after it has asked Git for the times of
// commits, and prints the slug, a tab and the name of each; `contents` prints the slug and a hash
// of what is in each (entry_content.h); `keys` gives each its seed
// (class_keys.h); `check` reads what `write` will need, before all gradings; `write` makes
// gradebook.csv, gradebook.json, class.html and class-slides.html in FOLDER of it, with `--names
// no` also class-no-names.html, and says how the class did; `feedback` packs the reports for those
// whose they are (feedback.h). Exit status: 0; 1 when somebody's work could be lost, as the last
// line says (tally.h); 2 after one message. Read next: export_archive.h, roster.h, class_keys.h,
// gradebook.h; grade_class.sh, which calls all but the last.
#include "class_keys.h"
#include "class_page.h"
#include "clean_text.h"
#include "complain.h"
#include "corrections.h"
#include "decisions.h"
#include "entry_content.h"
#include "export_archive.h"
#include "feedback.h"
#include "lateness.h"
#include "list_columns.h"
#include "look_alikes.h"
#include "number.h"
#include "option_table.h"
#include "owners.h"
#include "path.h"
#include "roster.h"
#include "tally.h"
#include "text_file.h"
#include "upload_csv.h"

#include <dirent.h>
#include <getopt.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { EXIT_ALL_GRADED = 0, EXIT_SOME_LOST = 1, EXIT_FAULT = 2 };

static int usage(void)
{
    fputs("usage: gradebook unpack BUILD ARCHIVE FOLDER\n"
          "       gradebook roster [--latest] [--commits] LAB-NUMBER SUBMISSIONS FOLDER\n"
          "       gradebook contents FOLDER <names\n"
          "       gradebook keys [--seed N] GRADER FOLDER <contents\n"
          "       gradebook check [LIST]... [--against OLD.json] LAB FOLDER\n"
          "       gradebook write [LIST]... [--against OLD.json] [--nothing 0|blank] "
          "[--names no] FOLDER\n"
          "       gradebook feedback [LIST]... moodle|canvas|ilias|folders|mail FOLDER\n"
          "LIST: --list PARTICIPANTS.csv, --column TITLE, --who WHO.csv, --changes CHANGES.csv, "
          "--due DUE, --late LATE; or --make as the first word: all from LIST=, COLUMN= ...\n",
          stderr);
    return EXIT_FAULT;
}

static int archive_unpack_and_print(const char *build, const char *archive, const char *folder)
{
    char unpacked[PATH_MAX];
    if (export_archive_unpack(build, archive, folder, unpacked) != 0) {
        return EXIT_FAULT;
    }
    puts(unpacked);
    return EXIT_ALL_GRADED;
}

// The lab with a number, for the names of its files; without files where there is none. Returns 0,
// or -1 after one message.
static int lab_find(int number, Manifest *manifest)
{
    struct dirent *entry;
    char lab[NAME_MAX + 1] = "";
    DIR *labs = opendir("labs");
    *manifest = (Manifest){0};
    while (labs != NULL && (entry = readdir(labs)) != NULL) {
        int n = -1;
        if (sscanf(entry->d_name, "%2d-", &n) == 1 && n == number) {
            snprintf(lab, sizeof lab, "%s", entry->d_name);
        }
    }
    if (labs != NULL) {
        closedir(labs);
    }
    return lab[0] != '\0' ? manifest_load_file(NULL, lab, manifest) : 0;
}

// Reads a line "SLUG<tab>NAME" for each entry, and prints "SLUG CONTENT" (class_keys.h).
static int contents_print(const char *folder)
{
    char *line = NULL;
    size_t n_bytes = 0;
    int result = EXIT_ALL_GRADED;
    while (result == EXIT_ALL_GRADED && getline(&line, &n_bytes, stdin) > 0) {
        char path[PATH_MAX], hex[CONTENT_HEX];
        line[strcspn(line, "\n")] = '\0';
        char *name = line + strcspn(line, "\t");
        name += *name != '\0';
        path_make(path, "%s/submissions/%.*s", folder, (int)strcspn(line, "\t"), line);
        const int outcome = entry_content(path, hex);
        printf("%.*s %s\n", (int)strcspn(line, "\t"), line, hex);
        if (outcome > 0) {
            complain(
                "gradebook: \"%s\": more than %d files or %d MB: it is graded anew at each run",
                name, CONTENT_MOST_FILES, CONTENT_MOST_MB);
        } else if (outcome < 0) {
            complain("gradebook: \"%s\": no memory to look into it", name);
            result = EXIT_FAULT;
        }
    }
    free(line);
    return result;
}

static int roster_make(int lab_number, const char *submissions, const char *folder, int only_latest,
                       int has_commits)
{
    char path[PATH_MAX];
    path_make(path, "%s/roster.json", folder);
    Manifest manifest;
    Roster roster = {0};
    int result = lab_find(lab_number, &manifest);
    if (result == 0) {
        result = roster_read(submissions, lab_number, &manifest, only_latest, folder, &roster);
        manifest_free(&manifest);
    }
    if (result == 0 && has_commits) {
        result = commits_take(folder, &roster);
    }
    if (result == 0) {
        result = roster_save(&roster, path);
    }
    for (int i = 0; result == 0 && i < roster.n_entrants; i++) {
        if (!roster.entrants[i].is_link) {
            printf("%s\t%s\n", roster.entrants[i].slug, roster.entrants[i].label);
        }
    }
    roster_free(&roster);
    return result == 0 ? EXIT_ALL_GRADED : EXIT_FAULT;
}

// What an instructor has to look at: names that look like one person's.
static void look_alikes_print(const LookAlikes *look_alikes)
{
    for (int i = 0; i < look_alikes->n_groups; i++) {
        const LookAlike *group = &look_alikes->groups[i];
        for (int r = 0; r < group->n_rows; r++) {
            const Row *row = group->rows[r];
            printf("%s\"%s\"", r == 0 ? "perhaps one person, each with a row: " : ", ",
                   row->entrant->entry);
            if (row->entrant->version > 0) {
                printf(" (a version that earns %d)", row->score);
            }
        }
        printf("\n");
    }
}

// Was nobody before this row left ungraded for the same reason?
static int reason_is_new(const Gradebook *gradebook, int row)
{
    for (int i = 0; i < row; i++) {
        if (gradebook->rows[i].status == ROW_NOT_GRADED &&
            strcmp(gradebook->rows[i].reason, gradebook->rows[row].reason) == 0) {
            return 0;
        }
    }
    return 1;
}

// What the grader said, for the first row with each reason: where a whole class could not be graded
// (no sandbox here, no space left), one cause stands behind all of them.
static void faults_print(const Gradebook *gradebook, const char *folder)
{
    for (int i = 0; i < gradebook->n_rows; i++) {
        const Row *row = &gradebook->rows[i];
        if (row->status != ROW_NOT_GRADED || !row->has_log || !reason_is_new(gradebook, i)) {
            continue;
        }
        char path[PATH_MAX];
        path_make(path, "%s/logs/%s.txt", folder, row->entrant->slug);
        char *log = text_file_read(path);
        char *said = message_clean(log);
        printf("The log of %s says:\n", row->entrant->label);
        for (const char *line = strtok(said, "\n"); line != NULL; line = strtok(NULL, "\n")) {
            printf("    %s\n", line);
        }
        free(said);
        free(log);
    }
}

// What is not entered, and why.
static void undecided_print(const Gradebook *gradebook, const Worksheet *worksheet)
{
    for (int i = 0; i < gradebook->n_rows; i++) {
        const Row *row = &gradebook->rows[i];
        const char *why = tally_why_undecided(gradebook, worksheet, row);
        if (why != NULL) {
            complain("gradebook: %s: %s: \"%s\": %s",
                     worksheet != NULL ? worksheet->path : gradebook->folder,
                     worksheet != NULL ? "not entered" : "to be decided", row->entrant->entry, why);
        }
    }
}

// What the instructor uploads, and where.
static void upload_print(const Worksheet *worksheet, const char *folder)
{
    if (worksheet == NULL || worksheet->grade_column < 0) {
        return;
    }
    const char *words = list_upload_words(worksheet->system);
    char *title = message_clean(worksheet->participants[0].cells[worksheet->grade_column]);
    printf("To upload: %s/upload.csv, your list with the column \"%s\" filled in%s%s\n", folder,
           title, words != NULL ? ": " : "", words != NULL ? words : "");
    free(title);
}

// Is any row somebody's of the list?
static int has_entered(const Worksheet *worksheet)
{
    int i = 0;
    while (i < worksheet->n_rows && worksheet->entered[i].n_participants == 0) {
        i++;
    }
    return i < worksheet->n_rows;
}

// How the class did, for the terminal. The last line counts everybody.
//   n_open   how many entries who.csv offers to decide
static void summary_print(const Gradebook *gradebook, const Worksheet *worksheet,
                          const LookAlikes *look_alikes, const Tally *tally, int n_open)
{
    const char *folder = gradebook->folder;
    double sum = 0;
    int n_counted = 0;  // an earlier attempt is no other student's
    int n_full = 0;
    int n_outdated = 0;
    for (int i = 0; i < gradebook->n_rows; i++) {
        const Row *row = &gradebook->rows[i];
        n_outdated += row->status == ROW_OUTDATED;
        if (row_is_counted(gradebook, row)) {
            n_counted++;
            sum += row->score;
            n_full += row->score == gradebook->max_score;
        }
    }
    printf("%d submissions, %d graded", gradebook->n_rows, gradebook->n_graded);
    if (gradebook->n_graded > 0) {
        printf(", mean %.1f of %d, %d with full marks", n_counted > 0 ? sum / n_counted : 0,
               gradebook->max_score, n_full);
    }
    if (n_outdated > 0) {
        printf("; %d outdated", n_outdated);
    }
    printf("\n");
    for (int i = 0; i < gradebook->n_rows; i++) {
        const Row *row = &gradebook->rows[i];
        if (row->status == ROW_NOT_GRADED) {
            printf("not graded: %s: %s\n", row->entrant->label, row->reason);
        } else if (row->status == ROW_NOTHING && row_that_counts(gradebook, row) == row) {
            printf("nothing of this lab: %s: %s\n", row->entrant->label, row->reason);
        }
    }
    faults_print(gradebook, folder);
    look_alikes_print(look_alikes);
    if (corrections_count_waiting(gradebook) > 0) {
        printf("%d corrections of points not applied, as nothing was graded there\n",
               corrections_count_waiting(gradebook));
    }
    lateness_tell(gradebook);
    printf("Gradebook: %s/gradebook.csv, %s/gradebook.json\n", folder, folder);
    upload_print(worksheet, folder);
    if (n_open > 0) {
        const char *what = worksheet == NULL             ? "the time"
                           : gradebook->lateness != NULL ? "the student or the time"
                                                         : "the student";
        printf("To be decided: write %s of each of %d into %s/who.csv, and give it as "
               "WHO=%s/who.csv\n",
               what, n_open, folder, folder);
    }
    if (worksheet != NULL && gradebook->n_graded > 0 && !has_entered(worksheet)) {
        printf("Nobody of the list handed in one of these: is it another course's?\n");
    }
    tally_write(stdout, tally);
    printf(": see %s/class.html\n", folder);
}

// ---- A class with the instructor's lists ------------------------------------------------------

typedef struct ListPaths {
    ListGiven list;                       // its path is NULL where it was not given
    const char *who, *changes, *against;  // each NULL where it was not given
    const char *due, *late;               // no paths (lateness.h); or NULL
} ListPaths;

typedef struct Class {
    Gradebook gradebook;
    Worksheet worksheet;
    const Worksheet *list;  // the worksheet, or NULL
    Decisions decisions;
    Corrections corrections;
    Lateness lateness;
} Class;

// What is graded anew has no points yet that a correction could lead beyond its bounds.
static void outdated_drop(Gradebook *gradebook)
{
    for (int i = 0; i < gradebook->n_rows; i++) {
        Row *row = &gradebook->rows[i];
        row->status = row->status == ROW_OUTDATED ? ROW_NOT_GRADED : row->status;
    }
}

// The list of participants, and what the instructor decided. Returns 0, or -1 after one message.
static int owners_load(const ListPaths *paths, const char *lab, Class *class)
{
    Gradebook *gradebook = &class->gradebook;
    const ListGiven *list = &paths->list;
    const int needs_list = list->column != NULL || (paths->who != NULL && paths->due == NULL);
    if (list->path == NULL && needs_list) {
        complain("gradebook: %s: found no list of participants beside it, expected LIST=",
                 list->column != NULL ? list->column : paths->who);
        return -1;
    }
    if (list->path != NULL) {
        if (worksheet_load(list, lab, gradebook, &class->worksheet) != 0) {
            return -1;
        }
        class->list = &class->worksheet;
    }
    if (paths->who != NULL) {
        if (decisions_load(paths->who, gradebook, class->list, &class->decisions) != 0) {
            return -1;
        }
        gradebook->decisions = &class->decisions;
    }
    if (class->list != NULL && owners_find(&class->worksheet, gradebook) != 0) {
        complain("gradebook: %s: out of memory", list->path);
        return -1;
    }
    return 0;
}

// Gather all. `lab`: the class is to be graded, as one of this lab; NULL: it was graded. Returns 0,
// or -1 after one message. Release with class_free() in both cases.
static int class_load(const char *folder, const char *lab, const ListPaths *paths, Class *class)
{
    *class = (Class){0};
    Gradebook *gradebook = &class->gradebook;
    if (gradebook_load(folder, lab == NULL ? paths->against : NULL, gradebook) != 0) {
        return -1;
    }
    if (lab != NULL) {
        outdated_drop(gradebook);
    }
    lab = lab != NULL ? lab : gradebook->lab;
    if (owners_load(paths, lab, class) != 0) {
        return -1;
    }
    if (paths->changes != NULL && lab == NULL) {
        complain("gradebook: %s: not applied, as nothing is graded", paths->changes);
    }
    if (paths->changes != NULL && lab != NULL &&
        (corrections_load(paths->changes, lab, gradebook, class->list, &class->corrections) != 0 ||
         corrections_apply(&class->corrections, gradebook) != 0)) {
        return -1;
    }
    if (paths->due == NULL && paths->late == NULL) {
        return 0;
    }
    return lateness_read(paths->due, paths->late, &class->lateness) != 0
               ? -1
               : lateness_apply(&class->lateness, gradebook, class->list);
}

static void class_free(Class *class)
{
    lateness_free(&class->lateness);
    corrections_free(&class->corrections);
    decisions_free(&class->decisions);
    worksheet_free(&class->worksheet);
    gradebook_free(&class->gradebook);
}

static int gradebook_check(const char *lab, const char *folder, const ListPaths *paths)
{
    Class class = {0};
    int result = paths->against != NULL ? gradebook_check_old(paths->against, lab) : 0;
    if (result == 0 &&
        (paths->list.path != NULL || paths->list.column != NULL || paths->who != NULL ||
         paths->changes != NULL || paths->due != NULL || paths->late != NULL)) {
        result = class_load(folder, lab, paths, &class);
    }
    class_free(&class);
    return result == 0 ? EXIT_ALL_GRADED : EXIT_FAULT;
}

// Write the files; then say how the class did. Returns 0, or -1 after one message.
static int files_write(const Gradebook *gradebook, const Worksheet *worksheet, int is_for_hall,
                       Tally *tally)
{
    const char *folder = gradebook->folder;
    char csv[PATH_MAX], json[PATH_MAX], page[PATH_MAX], hall[PATH_MAX], slides[PATH_MAX];
    char upload[PATH_MAX];
    path_make(csv, "%s/gradebook.csv", folder);
    path_make(json, "%s/gradebook.json", folder);
    path_make(page, "%s/class.html", folder);
    path_make(hall, "%s/class-no-names.html", folder);
    path_make(slides, "%s/class-slides.html", folder);
    path_make(upload, "%s/upload.csv", folder);
    // Those that are not asked for again would be of older scores.
    unlink(hall), unlink(upload);
    LookAlikes look_alikes;
    int n_open = 0;
    if (look_alikes_find(gradebook, &look_alikes) != 0) {
        return -1;
    }
    *tally = tally_count(gradebook, worksheet, look_alikes.n_groups);
    const int failed = gradebook_csv(gradebook, csv, worksheet) != 0 ||
                       gradebook_json(gradebook, json, worksheet) != 0 ||
                       gradebook_page(gradebook, page, worksheet) != 0 ||
                       gradebook_slides(gradebook, slides) != 0 ||
                       (is_for_hall && gradebook_page_without_names(gradebook, hall) != 0) ||
                       (worksheet != NULL && upload_csv(gradebook, upload, worksheet) != 0) ||
                       decisions_offer(gradebook, worksheet, &n_open) != 0;
    if (!failed) {
        undecided_print(gradebook, worksheet);
        summary_print(gradebook, worksheet, &look_alikes, tally, n_open);
    }
    look_alikes_free(&look_alikes);
    return failed ? -1 : 0;
}

static int gradebook_write(const char *folder, const ListPaths *paths, int nothing_is_zero,
                           int is_for_hall)
{
    Class class;
    Tally tally;
    int status = EXIT_FAULT;
    if (class_load(folder, NULL, paths, &class) == 0) {
        class.gradebook.nothing_is_zero = nothing_is_zero;
        gradebook_tell_forgotten(&class.gradebook);
        if (files_write(&class.gradebook, class.list, is_for_hall, &tally) == 0) {
            const int has_lost =
                tally_has_lost(&tally) || corrections_count_waiting(&class.gradebook) > 0;
            status = has_lost ? EXIT_SOME_LOST : EXIT_ALL_GRADED;
        }
    }
    class_free(&class);
    return status;
}

// Are the points those of the class's gradebook? Else reports would go out with other points than
// the marks. Returns 0, or -1 after one message.
static int points_check(const Gradebook *gradebook)
{
    int n_others = 0;
    for (int i = 0; i < gradebook->n_rows; i++) {
        const Row *row = &gradebook->rows[i];
        n_others += row->has_old_score && row->score != row->old_score;
    }
    if (n_others > 0) {
        complain(
            "gradebook: found other points than in gradebook.json for %d submissions, expected "
            "the CHANGES=, DUE=, LATE= and LIST= of the last make grade-class",
            n_others);
    }
    return n_others > 0 ? -1 : 0;
}

static int give_back(const char *kind_name, const char *folder, const ListPaths *given)
{
    FeedbackKind kind;
    Class class;
    ListPaths with_old = *given;
    const ListPaths *paths = &with_old;
    char old[PATH_MAX];
    path_make(old, "%s/gradebook.json", folder);
    with_old.against = access(old, R_OK) == 0 ? old : NULL;
    if (feedback_kind_find(kind_name, &kind) != 0) {
        complain("gradebook: found \"%s\", expected moodle, canvas, ilias, folders or mail",
                 kind_name);
        return EXIT_FAULT;
    }
    const int failed = class_load(folder, NULL, paths, &class) != 0 ||
                       points_check(&class.gradebook) != 0 ||
                       feedback_write(&class.gradebook, class.list, kind) != 0;
    class_free(&class);
    return failed ? EXIT_FAULT : EXIT_ALL_GRADED;
}

typedef struct GradebookOptions {
    int only_latest, has_commits;
    uint64_t seed;
    ListPaths paths;
    const char *nothing, *names;
    int help;
} GradebookOptions;

#define PLACE(member) offsetof(GradebookOptions, member)

int main(int argc, char **argv)
{
    enum { N_FROM_MAKE = 10, SEED = N_FROM_MAKE, N_ROWS = 14 };
    static const OptionRow rows[N_ROWS] = {
        {.name = "list", .argument = "PARTICIPANTS", .place = PLACE(paths.list.path)},
        {.name = "moodle", .argument = "WORKSHEET", .place = PLACE(paths.list.path)},  // older
        {.name = "column", .argument = "TITLE", .place = PLACE(paths.list.column)},
        {.name = "who", .argument = "WHO", .place = PLACE(paths.who)},
        {.name = "changes", .argument = "CHANGES", .place = PLACE(paths.changes)},
        {.name = "due", .argument = "DUE", .place = PLACE(paths.due)},
        {.name = "late", .argument = "LATE", .place = PLACE(paths.late)},
        {.name = "against", .argument = "OLD", .place = PLACE(paths.against)},
        {.name = "nothing", .argument = "0|blank", .place = PLACE(nothing)},
        {.name = "names", .argument = "no", .place = PLACE(names)},
        [SEED] = {.name = "seed", .argument = "N", .kind = OPTION_SEED, .place = PLACE(seed)},
        {.name = "latest", .kind = OPTION_FLAG, .place = PLACE(only_latest)},
        {.name = "commits", .kind = OPTION_FLAG, .place = PLACE(has_commits)},
        {.name = "help", .kind = OPTION_ANSWER, .place = PLACE(help)},
    };
    const OptionTable table = {"gradebook", rows, N_ROWS, 1, N_FROM_MAKE};
    GradebookOptions options = {0};
    int is_given[N_ROWS];
    const OptionsResult result = option_table_read(&table, argc, argv, &options, is_given);
    if (result != OPTIONS_RUN) {
        return result == OPTIONS_DONE ? usage() : EXIT_FAULT;
    }
    argv += optind, argc -= optind;
    uint64_t lab;
    if (argc == 4 && strcmp(argv[0], "unpack") == 0) {
        return archive_unpack_and_print(argv[1], argv[2], argv[3]);
    }
    if (argc == 4 && strcmp(argv[0], "roster") == 0 &&
        number_read_unsigned(argv[1], 0, 99, &lab) == 0) {
        return roster_make((int)lab, argv[2], argv[3], options.only_latest, options.has_commits);
    }
    if (argc == 2 && strcmp(argv[0], "contents") == 0) {
        return contents_print(argv[1]);
    }
    if (argc == 3 && strcmp(argv[0], "keys") == 0) {
        const uint64_t *seed = is_given[SEED] ? &options.seed : NULL;
        return class_keys_make(argv[2], seed, argv[1], stdin) == 0 ? EXIT_ALL_GRADED : EXIT_FAULT;
    }
    if (argc == 3 && strcmp(argv[0], "check") == 0) {
        return gradebook_check(argv[1], argv[2], &options.paths);
    }
    if (argc == 2 && strcmp(argv[0], "write") == 0) {
        const int is_zero = options.nothing != NULL && strcmp(options.nothing, "0") == 0;
        return gradebook_write(argv[1], &options.paths, is_zero, options.names != NULL);
    }
    if (argc == 3 && strcmp(argv[0], "feedback") == 0) {
        return give_back(argv[1], argv[2], &options.paths);
    }
    return usage();
}
