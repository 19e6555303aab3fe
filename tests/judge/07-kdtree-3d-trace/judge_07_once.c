// Judging how often lab 07's search_leaf calls intersect_sphere: once for each sphere of the leaf.
#include "judge_07.h"
#include "message.h"
#include "words.h"

#define GIVEN                                                                                      \
    const SearchJob *in = &((const Job07 *)job)->inputs.leaves[i];                                 \
    const u32 found = ((const SearchAnswer *)answers)[i].n_tests
#define IS_FOUND(expected) (found == (expected))

RIGHT(is_right, IS_FOUND(in->node.n_spheres))

// ---- Mistakes -----------------------------------------------------------------------------------

static int lists(const Inputs07 *inputs, KdNode3 leaf, u32 sphere)
{
    u32 k = 0;
    while (k < leaf.n_spheres && inputs->leaf_ids[leaf.first + k] != sphere) {
        k++;
    }
    return k < leaf.n_spheres;
}

// Is a hit found, in whichever leaf? Then spheres were asked, counted or not.
static int is_any_found(const void *job, const void *answers)
{
    const SearchJob *in = ((const Job07 *)job)->inputs.leaves;
    int i = 0;
    while (i < N_LEAVES && ((const SearchAnswer *)answers)[i].sphere == in[i].sphere) {
        i++;
    }
    return i < N_LEAVES;
}

KNOWN_LIST(known)
{
    GIVEN;

    EACH(uncounted, IS_FOUND(0) && is_any_found(job, answers),
         "hits are found, but their calls were not counted in the `work` that was handed in");
    EACH(unasked, IS_FOUND(0) && !is_any_found(job, answers),
         "no hit is found, and no sphere was asked: from where to where does the loop run?");
    // A loop from first to before n_spheres.
    ANSWERS(to_count, in->node.first < in->node.n_spheres ? in->node.n_spheres - in->node.first : 0,
            "node.n_spheres was taken for the end of the range: it is how many there are");
    ONLY(more, found > in->node.n_spheres,
         "some spheres were asked more than once: a distance that is needed twice can be kept");
    // It need not be where a nearer one comes before it.
    ONLY(not_again,
         found + 1 == in->node.n_spheres &&
             lists(&((const Job07 *)job)->inputs, in->node, in->sphere),
         "the sphere that is hit already was not asked again: the contract is once for each");

    ONLY(fewer, found < in->node.n_spheres,
         "not each sphere of the leaf is asked: the loop ends before the last one, or passes some "
         "over");
    return NO_MORE;
}

// ---- Answers ------------------------------------------------------------------------------------

static char *describe(const void *job, int i, const void *answers)
{
    GIVEN;
    const u32 n_spheres = in->node.n_spheres;
    return message_new("a leaf of %u sphere%s: intersect_sphere was called %u times, expected %u, "
                       "once for each sphere of the leaf",
                       n_spheres, plural(n_spheres), found, n_spheres);
}

const Function leaf_once_07 = {"leaves", N_LEAVES, sizeof(SearchAnswer),
                               KNOWING(is_right, describe, known), .knows_constant = 1};
