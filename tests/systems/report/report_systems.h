// Writing one Result for the systems that courses use. As in report.h, each file appears whole or
// not at all, and each function returns 0, or -1 after one message on stderr.
//
// A fault of the machinery must not look like a zero. Where a format has a way to say so, a second
// function writes that; where it has none, the system takes a missing file for the fault it is.
#ifndef GRADER_REPORT_SYSTEMS_H
#define GRADER_REPORT_SYSTEMS_H

#include "manifest.h"
#include "result.h"

// A report's formats, as bits of a set.
typedef unsigned FormatSet;

// Read "junit,tap". Returns 0, or -1 after one message on stderr that lists the formats.
int formats_read(const char *names, FormatSet *formats);

// Write the formats of the set into a folder: junit.xml, results.tap, gradescope.json,
// autolab.txt, prairielearn.json, github.txt.
int formats_write(const char *folder, FormatSet formats, const Manifest *manifest,
                  const Result *result);

// The same after a fault of the machinery: what says so in each format, and no file in the others,
// not even an older one.
int formats_write_fault(const char *folder, FormatSet formats, const char *lab);

// What a person reads in place of a result; the fault itself is on stderr.
#define FORMATS_FAULT_TEXT "The grader could not work. This is no grade; its log says why."

// JUnit XML, for any continuous integration; the schema is tests/systems/junit.xsd.
int report_junit(const char *path, const Manifest *manifest, const Result *result);
int report_junit_fault(const char *path, const char *lab);

// The Test Anything Protocol, version 13. https://testanything.org/tap-version-13-specification
int report_tap(const char *path, const Manifest *manifest, const Result *result);
int report_tap_fault(const char *path, const char *lab);

// Gradescope's results.json. https://gradescope-autograders.readthedocs.io/en/latest/specs/
int report_gradescope(const char *path, const Manifest *manifest, const Result *result);

// The last lines on stdout that Autolab reads. https://docs.autolabproject.com/lab/
int report_autolab(const char *path, const Manifest *manifest, const Result *result);

// PrairieLearn's results.json, of at most 1 MB.
// https://prairielearn.readthedocs.io/en/latest/externalGrading/
int report_prairielearn(const char *path, const Manifest *manifest, const Result *result);
int report_prairielearn_fault(const char *path, const char *lab);

// The workflow commands that GitHub Classroom reads the points from.
// https://github.com/classroom-resources/autograding-grading-reporter
int report_github(const char *path, const Manifest *manifest, const Result *result);

#endif
