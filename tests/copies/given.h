// The forms that a course gives its students, or has met before.
#ifndef COPIES_GIVEN_H
#define COPIES_GIVEN_H

#include "forms.h"
#include "manifest.h"

typedef struct Given {
    Forms forms;
    int is_known;  // of a right or wrong answer for tests; else the course gives it to students
} Given;

// Read the skeleton's holes, the code on the lab's page, the solution's holes, and the known
// answers (tests/known). What is not there, as in a course without solutions, is
// left out.
//   scopes   by the manifest's tasks: the names around each hole (scope.h)
// Returns *n_given of them; given_free() them. Running out of memory ends the program.
Given *given_read(const Manifest *manifest, const NameSet scopes[], int *n_given);
void given_free(Given *given, int n_given);

#endif
