// What the bench of builds tells (see report_builds.h).
//
// Read next: bench_builds.gnuplot.
#include "report_builds.h"

#include "output_file.h"
#include "path.h"

#include <stdio.h>

static Spread spread_of_builds(const BuildCase *build_case)
{
    return spread_of(build_case->builds.ms, build_case->builds.n);
}

// What grows.
typedef double Quantity(const BuildCase *build_case);

static double median_ns(const BuildCase *build_case)
{
    return spread_of_builds(build_case).median * 1e6;
}

static double handed_on(const BuildCase *build_case)
{
    return build_case->size.n_handed_on;
}

// A law, fitted to a quantity of a builder's cases.
static Growth growth_of(const BuildCase *cases, int n_cases, Builder builder, Quantity *quantity,
                        Law law)
{
    double elements[N_SCENES] = {0}, quantities[N_SCENES] = {0};
    int n = 0;
    for (int i = 0; i < n_cases; i++) {
        if (cases[i].builder == builder) {
            elements[n] = cases[i].n_elements;
            quantities[n++] = quantity(&cases[i]);
        }
    }
    return growth_fit(law, elements, quantities, n);
}

static double per_leaf(const BuildCase *build_case)
{
    return build_case->size.n_listed / build_case->size.n_leaves;
}

static double per_element(const BuildCase *build_case, double total)
{
    return total / build_case->n_elements;
}

// ---- Tables ---------------------------------------------------------------------------------

static void print_case(const BuildCase *build_case)
{
    const Spread ms = spread_of_builds(build_case);
    char spread[32];
    snprintf(spread, sizeof spread, "(%.2f to %.2f)", ms.min, ms.max);
    printf("  %9d  %9.2f  %-20s  %7.0f  %9.1f  %8.1f  %7.1f  %7.1f\n", build_case->n_elements,
           ms.median, spread, per_element(build_case, median_ns(build_case)),
           per_element(build_case, handed_on(build_case)), per_leaf(build_case),
           per_element(build_case, build_case->size.n_bytes),
           per_element(build_case, build_case->n_peak_bytes));
}

static void print_cases(const BuildCase *cases, int n_cases)
{
    printf("\nBuilding a tree over N elements, circles in lab 02 and spheres else: milliseconds of "
           "processor time, on\none thread. For each element nanoseconds, how many nodes it is "
           "handed on to, bytes of the finished tree,\nand the most bytes that the builder has "
           "asked for at once; and the elements of a leaf\n");
    printf("  %9s  %9s  %-20s  %7s  %9s  %8s  %7s  %7s\n", "N", "ms", "(single builds)", "ns",
           "handed on", "per leaf", "tree", "peak");
    for (int i = 0; i < n_cases; i++) {
        if (i == 0 || cases[i].builder != cases[i - 1].builder) {
            printf("  %s\n", BUILDERS[cases[i].builder].title);
        }
        print_case(&cases[i]);
    }
}

static void print_laws(const BuildCase *cases, int n_cases, const char *title, Quantity *quantity)
{
    printf("  %-34s  %8s N log2 N + %6s N  %6s  %10s N  %6s\n", title, "a", "b", "off by", "b",
           "off by");
    for (int builder = 0; builder < N_BUILDERS; builder++) {
        const Growth n_log_n = growth_of(cases, n_cases, builder, quantity, N_LOG_N);
        const Growth linear = growth_of(cases, n_cases, builder, quantity, LINEAR);
        printf("  %-34s  %8.2f %17.2f    %4.0f %%  %10.2f    %4.0f %%\n", BUILDERS[builder].title,
               n_log_n.a, n_log_n.b, 100 * n_log_n.deviation, linear.b, 100 * linear.deviation);
    }
}

void report_builds_print(const BuildCase *cases, int n_cases)
{
    print_cases(cases, n_cases);
    printf("\nBy which law does it grow? Both are fitted; `off by` is the farthest case\n");
    print_laws(cases, n_cases, "handed on, counted", handed_on);
    print_laws(cases, n_cases, "time, ns (caches grow slower, too)", median_ns);
}

// ---- For the plot ---------------------------------------------------------------------------

static void write_row(FILE *file, const BuildCase *cases, int n_cases, const BuildCase *build_case)
{
    const Builder builder = build_case->builder;
    const Law law = BUILDERS[builder].law;
    const double n = build_case->n_elements;
    const Spread ms = spread_of_builds(build_case);
    fprintf(file, "%s,%d,%.4f,%.4f,%.4f,%.4f,%.0f,%.0f,%.2f,%.2f,%.2f\n", BUILDERS[builder].name,
            build_case->n_elements, ms.median, ms.min, ms.max,
            growth_at(growth_of(cases, n_cases, builder, median_ns, law), n) / 1e6,
            handed_on(build_case), growth_at(growth_of(cases, n_cases, builder, handed_on, law), n),
            per_leaf(build_case), per_element(build_case, build_case->size.n_bytes),
            per_element(build_case, build_case->n_peak_bytes));
}

int report_builds_write_csv(const BuildCase *cases, int n_cases, const char *folder)
{
    char path[PATH_MAX];
    OutputFile output;
    path_make(path, "%s/bench_builds.csv", folder);
    if (output_file_open(&output, path) != 0) {
        return -1;
    }
    fprintf(output.file, "builder,n_elements,median_ms,min_ms,max_ms,law_ms,handed_on,"
                         "law_handed_on,per_leaf,bytes_per_element,peak_bytes_per_element\n");
    for (int i = 0; i < n_cases; i++) {
        write_row(output.file, cases, n_cases, &cases[i]);
    }
    if (output_file_commit(&output) != 0) {
        return -1;
    }
    printf("The figures: %s\n", path);
    return 0;
}
