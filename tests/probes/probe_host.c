// Calling a student's functions on the host (ProbeFunction of probe.h), and replays of the calls
// that pack leaves.
#include "probe.h"

#include <stdlib.h>

static void call_each(const Probe *probe, const ProbeFunction *function)
{
    size_t n_bytes;
    const char *inputs = probe_job(probe, function->section, &n_bytes);
    const size_t n = n_bytes / function->input_bytes;
    char *answers = calloc(n, function->answer_bytes);
    for (size_t i = 0; i < n; i++) {
        probe_note(probe, function->section, (uint32_t)i);
        function->call(probe, inputs + i * function->input_bytes,
                       answers + i * function->answer_bytes);
    }
    probe_answer_array(probe, function->section, answers, n * function->answer_bytes);
}

void probe_call_host(const Probe *probe, const ProbeFunction *functions, size_t n)
{
    for (size_t i = 0; i < n; i++) {
        if (!probe_asks(probe, functions[i].section)) {
            continue;
        }
        if (functions[i].answer != NULL) {
            functions[i].answer(probe, functions[i].section);
        } else {
            call_each(probe, &functions[i]);
        }
    }
}

void probe_replay_leaves(const Probe *probe, const char *name, PackTree *pack_tree)
{
    size_t n_bytes;
    const ReplayTree *trees = probe_job(probe, "replay.trees", &n_bytes);
    const size_t n_trees = n_bytes / sizeof *trees;
    const ReplayList *leaves = probe_job(probe, name, &n_bytes);
    const size_t n = n_bytes / sizeof *leaves;
    size_t i = 0;
    for (uint32_t k = 0; k < n_trees; k++) {
        pack_tree(probe, k, trees[k], leaves + i, n - i);
        while (i < n && leaves[i].scene == k) {
            i++;
        }
    }
}
