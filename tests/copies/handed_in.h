// What a class has handed in of one lab: each author's answers, between the markers.
//
// Files are found and archives opened as the grader does it (submission.h). Read next: forms.h.
#ifndef COPIES_HANDED_IN_H
#define COPIES_HANDED_IN_H

#include "forms.h"
#include "manifest.h"
#include "roster.h"

typedef struct Answer {
    char *text;  // between the markers of a task; NULL: none, or the markers are not there
    Forms forms;
} Answer;

// One entry of the roster; of several attempts of one student the last with something of this lab.
typedef struct Author {
    const Entrant *entrant;
    Answer answers[MANIFEST_MAX_TASKS];  // by the manifest's tasks
    int is_given_up;  // reading them takes too much (trial.h): they have no forms
} Author;

typedef struct HandedIn {
    Manifest manifest;
    Roster roster;
    Author *authors;  // in the roster's order
    int n_authors;
    int n_without;           // entries with no answer to any task, or whose files cannot be used
    const Entrant **unread;  // entries that this machine could not read, [n_unread]
    int n_unread;
    NameSet scopes[MANIFEST_MAX_TASKS];  // by the manifest's tasks: names around each hole
} HandedIn;

// Read what a class has handed in.
//   build    "build": where tools/unpack is
//   lab      "03-kdtree-2d-render"
//   folder   has roster.json and submissions/SLUG (roster.h)
// An entry that this machine cannot read, as a folder of mode 0, is named on stderr and passed by.
// So is one that takes too much to read, which stays an author.
// Returns 0, or -1 after one message on stderr, also where no entry can be read. Release with
// handed_in_free() in either case.
int handed_in_read(const char *build, const char *lab, const char *folder, HandedIn *class);
void handed_in_free(HandedIn *class);

#endif
