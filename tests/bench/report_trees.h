// What the 3D bench tells of building: the trees of labs 06, 08 and 10, and Embree's.
#ifndef BENCH_REPORT_TREES_H
#define BENCH_REPORT_TREES_H

#include "report3d.h"

// Print the tables: on one thread, and where Embree took part on as many as it has.
void report_trees_print(const Case3D *cases, int n_cases, ReportContext context);

#endif
