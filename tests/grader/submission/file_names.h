// Names that a wanted file may have in a submission.
//
// Canvas, ILIAS, Moodle and browsers change the names of what is uploaded or saved twice. Such a
// name is the system's doing, so the file is taken. A name that the student changed is only told.
#ifndef GRADER_FILE_NAMES_H
#define GRADER_FILE_NAMES_H

typedef enum NameMatch {
    NAME_EXACT,    // gradient.cl
    NAME_CHANGED,  // by a system: gradient-1.cl, gradient (1).cl, 20261103102233_77_gradient.cl
    NAME_NEAR,     // by the student: Gradient.cl, gradient.cl.txt, SURNAME_gradient.cl
    NAME_OTHER,
} NameMatch;

// The number at the end of a name that a system changed: 2 of "gradient-2.cl" and of
// "gradient (2).cl", else 0. A later upload has a higher one.
int name_upload_number(const char *name);

// How does the name of a file match the wanted one?
NameMatch name_match(const char *name, const char *wanted);

#endif
