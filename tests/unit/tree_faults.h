// Trees to spoil, in 2D and in 3D: who of their judges objects, and what a fault is.
//
// Included by tree2d_subject.h and tree3d_subject.h, which say before what a Scene and a Tree are,
// and which JUDGES there are. Read next: test_tree2d_faults.c.
#ifndef UNIT_TREE_FAULTS_H
#define UNIT_TREE_FAULTS_H

#include "surroundings.h"
#include "told.h"

// A judge, one bit of those that object.
static const struct {
    int bit;
    const char *name;
    Diagnosis (*judge)(const Scene *, const Tree *);
} tree_judges[] = {JUDGES};
enum { N_JUDGES = sizeof tree_judges / sizeof *tree_judges };

// Which judges object. Messages are one line each and begin with the scene.
static inline int judges_against(const Scene *scene, const Tree *tree)
{
    int against = check_against(scene, tree);
    for (int i = 0; i < N_JUDGES; i++) {
        char *message = told(tree_judges[i].judge(scene, tree));
        if (message != NULL) {
            against |= tree_judges[i].bit;
            cr_expect(strchr(message, '\n') == NULL && strstr(message, title_of(scene)) == message,
                      "%s", message);
            free(message);
        }
    }
    return against;
}

// The same in words; what no judge has said is the tree's own check.
static inline const char *names_of(int against)
{
    static char names[128];
    names[0] = '\0';
    for (int i = 0; i < N_JUDGES; i++) {
        if (against & tree_judges[i].bit) {
            strcat(strcat(names, tree_judges[i].name), " ");
            against &= ~tree_judges[i].bit;
        }
    }
    return strcat(names, against != 0 ? "check" : "");
}

static inline void expect_no_objection(const Scene *scene)
{
    const int against = judges_against(scene, &scene->tree);
    cr_expect_eq(against, 0, "%s, maxDepth %d, targetElementsPerNode %d: %s", title_of(scene),
                 scene->limits.maxDepth, scene->limits.targetElementsPerNode, names_of(against));
}

// The message of a judge about one call must hold `says`; NULL: there must be none.
static inline void expect_says(Diagnosis diagnosis, const char *says)
{
    char *message = told(diagnosis);
    if (says == NULL) {
        cr_expect_null(message, "%s", message);
    } else {
        cr_expect(message != NULL && strstr(message, says) != NULL, "found \"%s\", expected \"%s\"",
                  message ? message : "(nothing)", says);
    }
    free(message);
}

// ---- Faults -------------------------------------------------------------------------------------

// A number in one of the tree's arrays, in the place of what is there.
typedef struct Edit {
    size_t array;  // the offset of its pointer in Tree
    size_t at, n_bytes;
    u32 value;
} Edit;

// Numbers that are wrong, or a function that spoils a tree in another way.
typedef struct Fault {
    const char *what;
    int against;       // who must object, and nobody else
    int judge;         // one of them, or 0,
    const char *says;  // and a part of its message
    Edit edits[4];
    void (*spoil)(Tree *tree);
} Fault;

static inline void fault_make(const Fault *fault, Tree *tree)
{
    for (const Edit *edit = fault->edits; edit < fault->edits + 4 && edit->n_bytes > 0; edit++) {
        char *array;
        memcpy(&array, (const char *)tree + edit->array, sizeof array);
        memcpy(array + edit->at, &edit->value, edit->n_bytes);
    }
    if (fault->spoil != NULL) {
        fault->spoil(tree);
    }
}

// A mistake in one task costs that task only, as far as the others can still be judged.
static inline void expect_found_by_its_judges_alone(const Scene *scene, const Fault *fault)
{
    Tree tree = tree_copy(&scene->tree);
    fault_make(fault, &tree);
    const int against = judges_against(scene, &tree);
    cr_expect_eq(against, fault->against, "%s: found by %s", fault->what, names_of(against));
    for (int i = 0; i < N_JUDGES; i++) {
        if (tree_judges[i].bit == fault->judge) {
            expect_says(tree_judges[i].judge(scene, &tree), fault->says);
        }
    }
    tree_free(&tree);
}

#endif
