// A term: the gradebooks of its labs, and who the students are in all of them.
//
// Read next: term.c, which reads the gradebooks; term_people.c, which joins rows of one person.
#ifndef CLASS_TERM_H
#define CLASS_TERM_H

enum { TERM_MAX_LABS = 100 };

typedef struct TermLab {
    struct json_t *json;  // the gradebook; owns all texts of a Term
    const char *folder;   // as it was given
    const char *lab;      // "03-kdtree-2d-render"
    int max_score;
} TermLab;

// One person in one lab: what the gradebook says.
typedef struct Entry {
    int lab;         // which of the labs
    const char *id;  // the row's, or "" where there is none
    const char *name, *address, *id_number;
    int has_score, score;
    const char *open;   // why there is no score, though there may be one some day; else NULL
    const char *alone;  // why it is joined with no other entry; else NULL
    int is_twin;        // an entry of the same name may be another person's
    int person;         // another entry of the same person, or itself: used while joining
} Entry;

// A row of the table.
typedef struct Person {
    const char *name, *address, *id_number;
    const Entry **entries;  // [n_labs]: NULL where the gradebook does not have the person
    const char *note;       // why a row that looks like this one's is apart; else NULL
    int sum, n_passed;
    int n_open;  // labs without a score that may get one
} Person;

typedef struct Term {
    TermLab labs[TERM_MAX_LABS];  // by name
    int n_labs;
    int pass;  // points from which a lab is passed
    int need;  // labs to pass; 0: there is no such rule
    int max_sum;
    Entry *entries;
    int n_entries;
    Person *persons;  // by name
    int n_persons;
    const Entry **cells;  // [n_persons * n_labs] of all persons
} Term;

// Read FOLDER/gradebook.json of each folder. Returns 0, or -1 after one message on stderr. Release
// with term_free().
int term_load(char *const *folders, int n_folders, Term *term);
void term_free(Term *term);

// Join the entries of each person to a row:
//   - by e-mail address or the university's number, else by exactly the same name;
//   - never by name where one lab has two of them, or where both have an address, or a number, and
//     these differ;
//   - never what the gradebook has entered for nobody.
// What is not joined keeps a row of its own, so that every entry is in exactly one row. Returns 0,
// or -1 after one message on stderr.
int term_join(Term *term);

// "yes", "no", or "open": no yet, but with the labs that may get a score it could be yes.
const char *term_admission(const Term *term, const Person *person);

// The table, as a CSV file; is_for_excel: with semicolons and a mark of UTF-8 at the beginning.
// Returns 0, or -1 after one message on stderr.
int term_csv(const Term *term, const char *path, int is_for_excel);

// What each lab's checks found, with no word about any person: for whoever teaches it next. As a
// JSON file; a short table of it is printed. Needs no term_join(). Returns 0, or -1 after one
// message on stderr.
int term_figures(const Term *term, const char *path);

// The same as a page, term.html.
int term_page(const Term *term, const char *path);

// What the row needs the instructor for, in one line, "" if for nothing. NULL: memory ran out.
// free() it.
char *term_note(const Term *term, const Person *person);

// How the rows did in a lab.
typedef struct TermCount {
    int n_scores, n_passed;
    double mean;  // of the scores that there are; 0 where there is none
} TermCount;
TermCount term_count(const Term *term, int lab);

#endif
