// Grouping rows by what went wrong (see failures.h).
#include "failures.h"

#include "complain.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>

// The next character of a sentence in which every number is one '#': "(3, -4.5e3)" is "(#, #)".
static int next_character(const char **at)
{
    const char *from = *at;
    const char *digits = from + (*from == '-' || *from == '+' || *from == '.');
    if (!isdigit((unsigned char)*digits)) {
        *at += *from != '\0';
        return (unsigned char)*from;
    }
    while (isdigit((unsigned char)*digits) || *digits == '.' || *digits == 'x' ||
           ((*digits == 'e' || *digits == 'E') && strspn(digits + 1, "+-0123456789") > 0) ||
           ((*digits == '+' || *digits == '-') && tolower((unsigned char)digits[-1]) == 'e')) {
        digits++;
    }
    // A full stop behind it ends the sentence.
    *at = digits[-1] == '.' ? digits - 1 : digits;
    return '#';
}

static int sentences_compare(const char *a, const char *b)
{
    int left, right;
    do {
        left = next_character(&a);
        right = next_character(&b);
    } while (left == right && left != '\0');
    return left - right;
}

// A row with one of its faults.
typedef struct Fault {
    const Row *row;
    int check;                     // as in Failure
    const char *cause, *sentence;  // as there
} Fault;

static int faults_alike(const Fault *a, const Fault *b)
{
    if (a->check != b->check) {
        return a->check - b->check;
    }
    const int order = (b->cause != NULL) - (a->cause != NULL);
    if (order != 0) {
        return order;
    }
    return a->cause != NULL ? strcmp(a->cause, b->cause)
                            : sentences_compare(a->sentence, b->sentence);
}

static int faults_compare(const void *left, const void *right)
{
    const Fault *a = left, *b = right;
    const int order = faults_alike(a, b);
    return order != 0 ? order : (a->row > b->row) - (a->row < b->row);
}

// The largest first; of equals the one whose first row comes first, then the lab's order of checks.
static int sizes_compare(const void *left, const void *right)
{
    const Failure *a = left, *b = right;
    int order = b->n_rows - a->n_rows;
    order = order != 0 ? order : (a->rows[0] > b->rows[0]) - (a->rows[0] < b->rows[0]);
    order = order != 0 ? order : a->check - b->check;
    return order != 0 ? order : (a->cause == NULL) - (b->cause == NULL);
}

static int count_found(const Row *row, int n_checks)
{
    int n = 0;
    for (int i = 0; i < n_checks; i++) {
        n += row->found[i] != NULL;
    }
    return n;
}

// All faults of all rows that count, in no order. Returns how many.
static int faults_list(const Gradebook *gradebook, Fault *faults)
{
    int n = 0;
    for (int i = 0; i < gradebook->n_rows; i++) {
        const Row *row = &gradebook->rows[i];
        if (!row_is_counted(gradebook, row)) {
            continue;
        }
        if (row->stage != NULL) {
            faults[n++] = (Fault){row, -1, row->stage, row->stage_said};
        }
        for (int c = 0; c < gradebook->n_checks; c++) {
            if (row->found[c] != NULL) {
                faults[n++] = (Fault){row, c, row->causes[c], row->found[c]};
            }
        }
    }
    return n;
}

static Failure failure_begin(const Gradebook *gradebook, const Fault *fault, const Row **rows)
{
    const Column *check = fault->check >= 0 ? &gradebook->checks[fault->check] : NULL;
    return (Failure){.check = fault->check,
                     .title = check != NULL ? check->title : fault->row->stage,
                     .id = check != NULL ? check->id : "",
                     .cause = check != NULL ? fault->cause : NULL,
                     .sentence = fault->sentence,
                     .rows = rows};
}

static void failure_add(Failure *failure, const Row *row, int n_checks)
{
    failure->rows[failure->n_rows++] = row;
    // What a program drew before it ended says nothing about its end.
    if (failure->check >= 0 && row->picture != NULL &&
        (failure->shown == NULL ||
         count_found(row, n_checks) < count_found(failure->shown, n_checks))) {
        failure->shown = row;
    }
}

int failures_find(const Gradebook *gradebook, Failures *failures)
{
    const size_t n_most = (size_t)gradebook->n_rows * (size_t)(gradebook->n_checks + 1) + 1;
    Fault *faults = calloc(n_most, sizeof *faults);
    *failures = (Failures){.failures = calloc(n_most, sizeof *failures->failures),
                           .rows = calloc(n_most, sizeof(const Row *))};
    if (faults == NULL || failures->failures == NULL || failures->rows == NULL) {
        complain("gradebook: out of memory");
        free(faults);
        failures_free(failures);
        return -1;
    }
    const int n = faults_list(gradebook, faults);
    qsort(faults, (size_t)n, sizeof *faults, faults_compare);
    Failure *failure = NULL;
    for (int i = 0; i < n; i++) {
        if (i == 0 || faults_alike(&faults[i - 1], &faults[i]) != 0) {
            failure = &failures->failures[failures->n_failures++];
            *failure = failure_begin(gradebook, &faults[i], &failures->rows[i]);
        }
        failure_add(failure, faults[i].row, gradebook->n_checks);
    }
    free(faults);
    qsort(failures->failures, (size_t)failures->n_failures, sizeof *failures->failures,
          sizes_compare);
    return 0;
}

void failures_free(Failures *failures)
{
    free(failures->failures);
    free(failures->rows);
    *failures = (Failures){0};
}
