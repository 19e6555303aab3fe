// Packing reports for those whose they are (see feedback.h). Read next: feedback_report.c.
//
// Names become parts of paths here, in an archive or a folder: only letters and digits of ASCII are
// kept of them (plain_name()), and what tells two apart is the system's number or the slug.
#include "feedback.h"

#include "complain.h"
#include "csv_cell.h"
#include "folder.h"
#include "list_cell.h"
#include "output_file.h"
#include "participant_fit.h"
#include "path.h"

#include <archive.h>
#include <archive_entry.h>
#include <ctype.h>
#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

enum { NAME_BYTES = 80 };

int feedback_kind_find(const char *name, FeedbackKind *kind)
{
    static const char *const names[N_FEEDBACK_KINDS] = {"moodle", "canvas", "ilias", "folders",
                                                        "mail"};
    for (int i = 0; i < N_FEEDBACK_KINDS; i++) {
        if (strcmp(name, names[i]) == 0) {
            *kind = (FeedbackKind)i;
            return 0;
        }
    }
    return -1;
}

// ---- Who gets what ------------------------------------------------------------------------------

// One report for one person.
typedef struct Parcel {
    const Row *row;
    const char *name;     // of the person
    const char *number;   // that the system knows the person by, or ""
    const char *address;  // or ""
} Parcel;

// How parcels are handed over: `give` returns 1 where it could, 0 where the system would not know
// whose it is, -1 after one message.
typedef struct Giving {
    const Gradebook *gradebook;
    int (*give)(struct Giving *giving, const Parcel *parcel);
    struct archive *zip;
    FILE *list;
    char folder[PATH_MAX];
    int n_given, n_unknown;
} Giving;

static void plain_name(const char *name, char plain[NAME_BYTES])
{
    int n = 0;
    for (; *name != '\0' && n < NAME_BYTES - 1; name++) {
        const unsigned char sign = (unsigned char)*name;
        if (sign < 128 && (isalnum(sign) || (sign == ' ' && n > 0))) {
            plain[n++] = (char)sign;
        } else if (n > 0 && plain[n - 1] != '-') {
            plain[n++] = '-';
        }
    }
    while (n > 0 && (plain[n - 1] == '-' || plain[n - 1] == ' ')) {
        n--;
    }
    plain[n] = '\0';
}

// A line for each, up to so many: they mostly have one reason.
static void not_given(Giving *giving, const Row *row, const char *why)
{
    enum { MOST_LINES = 20 };
    if (giving->n_unknown++ < MOST_LINES) {
        printf("not given back: %s: %s\n", row->entrant->label, why);
    } else if (giving->n_unknown == MOST_LINES + 1) {
        puts("not given back: others, too");
    }
}

// Returns 0, or -1 after one message.
static int parcel_hand(Giving *giving, const Parcel *parcel)
{
    const char *unknown = parcel->row->time_unknown;
    if (unknown != NULL) {
        not_given(giving, parcel->row, unknown);
        return 0;
    }
    const int given = giving->give(giving, parcel);
    giving->n_given += given > 0;
    if (given == 0) {
        not_given(giving, parcel->row,
                  giving->list != NULL ? "there is no address"
                                       : "the system's number is not known");
    }
    return given < 0 ? -1 : 0;
}

static int row_hand(Giving *giving, const Row *row)
{
    const Entrant *entrant = row->entrant;
    Parcel parcel = {row, entrant->name, entrant->number, ""};
    if (entrant->n_members == 0) {
        return parcel_hand(giving, &parcel);
    }
    int result = 0;
    for (int i = 0; i < entrant->n_members && result == 0; i++) {
        const Member *member = &entrant->members[i];
        parcel.name = member->name[0] != '\0' ? member->name : entrant->name;
        parcel.address = member->email;
        result = parcel_hand(giving, &parcel);
    }
    return result;
}

// With a list its lines are the persons, so that each of a team gets the team's report.
static int participants_hand(Giving *giving, const Worksheet *worksheet)
{
    int result = 0;
    for (int i = 1; i < worksheet->n_participants && result == 0; i++) {
        const Participant *participant = &worksheet->participants[i];
        if (participant->row != NULL && participant->row->status != ROW_NOT_GRADED) {
            char name[ENTRY_NAME_BYTES];
            participant_name(worksheet, participant, name);
            const Parcel parcel = {participant->row, name,
                                   participant_number(worksheet, participant),
                                   participant_address(worksheet, participant)};
            result = parcel_hand(giving, &parcel);
        }
    }
    for (int i = 0; i < giving->gradebook->n_rows && result == 0; i++) {
        const Row *row = &giving->gradebook->rows[i];
        if (worksheet->entered[i].n_participants == 0 && row->status != ROW_NOT_GRADED &&
            worksheet->entered[i].left_out == NULL &&
            row_that_counts(giving->gradebook, row) == row) {
            not_given(giving, row, "it is entered for nobody of the list");
        }
    }
    return result;
}

static int all_hand(Giving *giving, const Worksheet *worksheet)
{
    const Gradebook *gradebook = giving->gradebook;
    int result = 0;
    if (worksheet != NULL) {
        return participants_hand(giving, worksheet);
    }
    for (int i = 0; i < gradebook->n_rows && result == 0; i++) {
        const Row *row = &gradebook->rows[i];
        if (row->entrant->version > 0) {
            not_given(giving, row, "it is one of several versions: decide with LIST= and WHO=");
        } else if (row->status != ROW_NOT_GRADED && row_that_counts(gradebook, row) == row) {
            result = row_hand(giving, row);
        }
    }
    return result;
}

// Returns 0, or -1 after one message.
static int report_copy(const Giving *giving, const Row *row, const char *to)
{
    size_t n_bytes;
    OutputFile output;
    char *report = feedback_report(giving->gradebook, row, &n_bytes);
    int result = report != NULL ? output_file_open(&output, to) : -1;
    if (result == 0) {
        fwrite(report, 1, n_bytes, output.file);
        result = output_file_commit(&output);
    }
    free(report);
    return result;
}

// ---- Archives -----------------------------------------------------------------------------------

// Put a row's report into the archive. Returns 1, or -1 after one message.
static int zip_put(Giving *giving, const Row *row, const char *name)
{
    size_t n_bytes;
    char from[PATH_MAX];
    struct stat status;
    feedback_report_path(giving->gradebook, row, from);
    char *report = feedback_report(giving->gradebook, row, &n_bytes);
    if (report == NULL) {
        return -1;
    }
    struct archive_entry *entry = archive_entry_new();
    int failed = entry == NULL || stat(from, &status) != 0;
    if (!failed) {
        archive_entry_set_pathname_utf8(entry, name);
        archive_entry_set_size(entry, (la_int64_t)n_bytes);
        archive_entry_set_filetype(entry, AE_IFREG);
        archive_entry_set_perm(entry, 0644);
        archive_entry_set_mtime(entry, status.st_mtime, 0);
        failed = archive_write_header(giving->zip, entry) != ARCHIVE_OK ||
                 archive_write_data(giving->zip, report, n_bytes) != (la_ssize_t)n_bytes;
    }
    if (failed) {
        complain("gradebook: %s: cannot be packed: %s", from, strerror(errno));
    }
    archive_entry_free(entry);
    free(report);
    return failed ? -1 : 1;
}

// "Ada Lovelace_1234567_assignsubmission_file_/report.html": Moodle parts it at its underscores,
// and takes the second part for the participant's number (importziplib.php).
static int give_to_moodle(Giving *giving, const Parcel *parcel)
{
    char plain[NAME_BYTES], name[PATH_MAX];
    const char *digits = parcel->number + strcspn(parcel->number, "0123456789");
    if (*digits == '\0' || digits[strspn(digits, "0123456789")] != '\0') {
        return 0;
    }
    plain_name(parcel->name, plain);
    path_make(name, "%s_%s_assignsubmission_file_/report.html", plain[0] != '\0' ? plain : "x",
              digits);
    return zip_put(giving, parcel->row, name);
}

// "lovelaceada_40012_880036_report.html": Canvas takes the first two numbers for those of the
// student and of a file that the student handed in (generate_comments_from_files). Both are in the
// entry.
static int give_to_canvas(Giving *giving, const Parcel *parcel)
{
    char name[PATH_MAX];
    const char *entry = parcel->row->entrant->entry, *rest = entry;
    int n_numbers = 0;
    while (n_numbers < 2 && (rest = strchr(rest, '_')) != NULL) {
        rest++;
        const size_t n_digits = strspn(rest, "0123456789");
        n_numbers += n_digits > 0 && rest[n_digits] == '_';
        if (n_digits > 0 && rest[n_digits] != '_' && n_numbers > 0) {
            return 0;
        }
    }
    if (n_numbers < 2) {
        return 0;
    }
    rest += strspn(rest, "0123456789");
    path_make(name, "%.*s_report.html", (int)(rest - entry), entry);
    return strchr(name, '/') != NULL ? 0 : zip_put(giving, parcel->row, name);
}

// "multi_feedback/Ada Lovelace_40012/report.html": ILIAS looks for three parts, the first of which
// begins so, and takes what is behind the last underscore of the second for the number of a user
// (TutorFeedbackZipRepository). It is in the entry, a folder that ILIAS has named.
static int give_to_ilias(Giving *giving, const Parcel *parcel)
{
    const Entrant *entrant = parcel->row->entrant;
    char plain[NAME_BYTES], name[PATH_MAX], folder[PATH_MAX];
    // A version is called by the folder and the file in it.
    path_make(folder, "%.*s", (int)strcspn(entrant->entry, "/"), entrant->entry);
    const SystemName read = system_name_read(folder, SYSTEM_ILIAS);
    if (read.system != SYSTEM_ILIAS || strlen(entrant->number) != read.number.length ||
        strncmp(entrant->number, read.number.text, read.number.length) != 0) {
        return 0;
    }
    plain_name(parcel->name, plain);
    path_make(name, "multi_feedback/%s_%s/report.html", plain[0] != '\0' ? plain : "x",
              entrant->number);
    return zip_put(giving, parcel->row, name);
}

// Returns 0, or -1 after one message.
static int zip_write(Giving *giving, const Worksheet *worksheet, const char *path)
{
    OutputFile output;
    if (output_file_open(&output, path) != 0) {
        return -1;
    }
    giving->zip = archive_write_new();
    int failed = giving->zip == NULL || archive_write_set_format_zip(giving->zip) != ARCHIVE_OK ||
                 archive_write_set_options(giving->zip, "hdrcharset=UTF-8") != ARCHIVE_OK ||
                 archive_write_open_FILE(giving->zip, output.file) != ARCHIVE_OK;
    failed = failed || all_hand(giving, worksheet) != 0;
    if (giving->zip != NULL && archive_write_close(giving->zip) != ARCHIVE_OK && !failed) {
        complain("gradebook: %s: %s", path, archive_error_string(giving->zip));
        failed = 1;
    }
    archive_write_free(giving->zip);
    if (failed) {
        output_file_discard(&output);
        return -1;
    }
    return output_file_commit(&output);
}

// ---- Folders, and the list for mail -------------------------------------------------------------

static int give_as_folder(Giving *giving, const Parcel *parcel)
{
    char plain[NAME_BYTES], folder[PATH_MAX], to[PATH_MAX];
    plain_name(parcel->name, plain);
    path_make(folder, "%s/%s-%s", giving->folder, plain, parcel->row->entrant->slug);
    path_make(to, "%s/report.html", folder);
    if (mkdir(folder, 0700) != 0 && errno != EEXIST) {
        complain("gradebook: %s: cannot be made: %s", folder, strerror(errno));
        return -1;
    }
    if (report_copy(giving, parcel->row, to) != 0) {
        return -1;
    }
    char *comment = row_comment(giving->gradebook, parcel->row);
    csv_cell_write(giving->list, parcel->address);
    fputc(',', giving->list);
    csv_cell_write(giving->list, parcel->name);
    if (row_is_entered(giving->gradebook, parcel->row)) {
        fprintf(giving->list, ",%d,%d,", parcel->row->score, giving->gradebook->max_score);
    } else {
        fputs(",,,", giving->list);
    }
    csv_cell_write(giving->list, to + strlen(giving->gradebook->folder) + 1);
    fputc(',', giving->list);
    csv_cell_write(giving->list, comment != NULL ? comment : "");
    fputc('\n', giving->list);
    free(comment);
    return 1;
}

static int give_by_mail(Giving *giving, const Parcel *parcel)
{
    return parcel->address[0] != '\0' ? give_as_folder(giving, parcel) : 0;
}

// Returns 0, or -1 after one message.
static int folders_write(Giving *giving, const Worksheet *worksheet, const char *path)
{
    OutputFile output;
    path_make(giving->folder, "%s/feedback", giving->gradebook->folder);
    if ((folder_remove(giving->folder) != 0 && errno != ENOENT) ||
        mkdir(giving->folder, 0700) != 0) {
        complain("gradebook: %s: cannot be made anew: %s", giving->folder, strerror(errno));
        return -1;
    }
    if (output_file_open(&output, path) != 0) {
        return -1;
    }
    giving->list = output.file;
    fputs("address,name,score,max,report,comment\n", output.file);
    if (all_hand(giving, worksheet) != 0) {
        output_file_discard(&output);
        return -1;
    }
    return output_file_commit(&output);
}

// ---- All ----------------------------------------------------------------------------------------

int feedback_write(const Gradebook *gradebook, const Worksheet *worksheet, FeedbackKind kind)
{
    static const struct {
        const char *file;
        int (*give)(Giving *giving, const Parcel *parcel);
        int (*write)(Giving *giving, const Worksheet *worksheet, const char *path);
        const char *next;
    } ways[N_FEEDBACK_KINDS] = {
        {"feedback-moodle.zip", give_to_moodle, zip_write,
         "in the assignment choose Upload multiple feedback files in a zip"},
        {"feedback-canvas.zip", give_to_canvas, zip_write,
         "on the assignment's page choose Upload Submissions"},
        {"feedback-ilias.zip", give_to_ilias, zip_write,
         "in Submissions and Grades choose the assignment, and upload it as Multi-Feedback"},
        {"feedback.csv", give_as_folder, folders_write, "the folders are in feedback/"},
        {"feedback.csv", give_by_mail, folders_write,
         "for a mail merge: address, name, score, report, comment"},
    };
    char path[PATH_MAX];
    Giving giving = {.gradebook = gradebook, .give = ways[kind].give};
    path_make(path, "%s/%s", gradebook->folder, ways[kind].file);
    if (ways[kind].write(&giving, worksheet, path) != 0) {
        return -1;
    }
    printf("%d reports given back, %d not: %s\n%s\n", giving.n_given, giving.n_unknown, path,
           ways[kind].next);
    return 0;
}
