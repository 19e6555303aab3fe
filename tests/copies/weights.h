// How much each form tells about who wrote it: the fewer of the class have it, the more.
//
// A form that n of N authors have weighs log(N / n); 0 where the course itself gives it: in the
// skeleton, on the lab's page, in the solution. Read next: pairs.h.
#ifndef COPIES_WEIGHTS_H
#define COPIES_WEIGHTS_H

#include "given.h"
#include "handed_in.h"

typedef struct Weight {
    const Form *form;  // one of those that are alike
    int n_authors;     // who have it
    int is_given;      // the course gives it
    int is_known;      // a known answer has it, right or wrong: it is found again and again
    double nats;       // what it weighs, in units of the natural logarithm
} Weight;

typedef struct Weights {
    Weight *all;  // by the ids of forms
    int n;
    Given *given;  // its forms have ids, too
    int n_given;
} Weights;

// Number the forms of all answers, so that alike ones have one id, and weigh them. Release with
// weights_free(). Running out of memory ends the program.
void weights_make(HandedIn *class, Weights *weights);
void weights_free(Weights *weights);

#endif
