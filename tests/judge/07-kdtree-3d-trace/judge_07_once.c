// Judging how often lab 07's search_leaf calls intersect_sphere: once for each sphere of the leaf.
#include "judge_07.h"
#include "message.h"
#include "words.h"

static int once_agrees(const void *job, int i, const void *answers, int mistake)
{
    (void)mistake;
    return ((const SearchAnswer *)answers)[i].n_tests ==
           ((const Job07 *)job)->inputs.leaves[i].node.n_spheres;
}

static char *describe_once(const void *job, int i, const void *answers)
{
    const u32 n_spheres = ((const Job07 *)job)->inputs.leaves[i].node.n_spheres;
    return message_new("a leaf of %u sphere%s: intersect_sphere was called %u times, expected %u, "
                       "once for each sphere of the leaf",
                       n_spheres, plural(n_spheres), ((const SearchAnswer *)answers)[i].n_tests,
                       n_spheres);
}

static int lists(const Inputs07 *inputs, KdNode3 leaf, u32 sphere)
{
    u32 k = 0;
    while (k < leaf.n_spheres && inputs->leaf_ids[leaf.first + k] != sphere) {
        k++;
    }
    return k < leaf.n_spheres;
}

// Was nothing counted at all, or only too much?
static Cause explain_count(const Inputs07 *inputs, Range range, const SearchAnswer *found)
{
    int n_counted = 0, n_less = 0, is_to_count = 1;
    for (int k = 0; k < range.n; k++) {
        const int i = range_at(range, k);
        n_counted += found[i].n_tests > 0;
        const KdNode3 leaf = inputs->leaves[i].node;
        n_less += found[i].n_tests < leaf.n_spheres;
        // A loop from first to before n_spheres.
        is_to_count &=
            found[i].n_tests == (leaf.first < leaf.n_spheres ? leaf.n_spheres - leaf.first : 0);
    }
    return (Cause){.says = n_counted == 0 ? "the calls were not counted in the `work` that was "
                                            "handed in"
                           : is_to_count  ? "node.n_spheres was taken for the end of the range: "
                                            "it is how many there are"
                           : n_less == 0  ? "some spheres were asked more than once: a distance "
                                            "that is needed twice can be kept"
                                          : NULL};
}

// Is it the sphere of the hit so far that was left out, and nothing else? It need not be where a
// nearer one comes before it.
static Cause explain_once(const void *job, Range range, const void *answers)
{
    const Inputs07 *inputs = &((const Job07 *)job)->inputs;
    const Cause by_count = explain_count(inputs, range, answers);
    int k = 0;
    for (; by_count.says == NULL && k < range.n; k++) {
        const int i = range_at(range, k);
        const SearchJob *leaf = &inputs->leaves[i];
        const u32 n_skipped = leaf->node.n_spheres - ((const SearchAnswer *)answers)[i].n_tests;
        if (n_skipped > (lists(inputs, leaf->node, leaf->sphere) ? 1 : 0)) {
            break;
        }
    }
    const int is_all = k == range.n;
    if (by_count.says != NULL) {
        return by_count;
    }
    return (Cause){.says = is_all ? "the sphere that is hit already was not asked again: the "
                                    "contract is once for each"
                                  : NULL};
}

const Function leaf_once_07 = {"leaves", N_LEAVES, sizeof(SearchAnswer),
                               EXPLAINED(once_agrees, describe_once, explain_once)};
