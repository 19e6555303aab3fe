// Grouping rows by what went wrong first (see failures.h).
#include "failures.h"

#include <ctype.h>
#include <stdio.h>
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

static int failures_compare(const Row *a, const Row *b)
{
    int order = strcmp(a->fault_id, b->fault_id);
    order = order != 0 ? order : strcmp(a->fault, b->fault);
    return order != 0 ? order : sentences_compare(a->fault_message, b->fault_message);
}

static int rows_compare(const void *left, const void *right)
{
    const Row *a = *(const Row *const *)left;
    const Row *b = *(const Row *const *)right;
    const int order = failures_compare(a, b);
    return order != 0 ? order : (a > b) - (a < b);
}

// The largest first; of equals the one whose first row comes first.
static int sizes_compare(const void *left, const void *right)
{
    const Failure *a = left;
    const Failure *b = right;
    return a->n_rows != b->n_rows ? b->n_rows - a->n_rows
                                  : (a->first > b->first) - (a->first < b->first);
}

int failures_find(const Gradebook *gradebook, Failures *failures)
{
    const size_t n_most = (size_t)gradebook->n_rows + 1;
    *failures = (Failures){.failures = calloc(n_most, sizeof *failures->failures),
                           .rows = calloc(n_most, sizeof *failures->rows)};
    if (failures->failures == NULL || failures->rows == NULL) {
        fprintf(stderr, "gradebook: out of memory\n");
        failures_free(failures);
        return -1;
    }
    int n = 0;
    for (int i = 0; i < gradebook->n_rows; i++) {
        if (gradebook->rows[i].fault != NULL) {
            failures->rows[n++] = &gradebook->rows[i];
        }
    }
    qsort(failures->rows, (size_t)n, sizeof *failures->rows, rows_compare);
    Failure *failure = NULL;
    for (int i = 0; i < n; i++) {
        if (failure == NULL || failures_compare(failure->first, failures->rows[i]) != 0) {
            failure = &failures->failures[failures->n_failures++];
            *failure = (Failure){failures->rows[i], 0, &failures->rows[i]};
        }
        failure->n_rows++;
    }
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
