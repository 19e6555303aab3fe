# shellcheck shell=sh
# Spreading a class over the processors of this machine, with GNU parallel (see grade_class.sh).

# engine_check: can it work here?
engine_check() {
    command -v parallel >/dev/null || die "GNU parallel is missing: install the package parallel"
}

# engine_run LIST [JOBS]: grade_one.sh for each line of the file LIST.
engine_run() {
    bar=
    [ ! -t 2 ] || bar=--bar
    # Killed at the wrong moment, parallel leaves its temporary files: here they are cleared.
    mkdir -p "$CLASS_WORK-parallel" || return
    # It ends with the driver, and each of its jobs with it. Its users' habits, in PARALLEL or in a profile,
    # are not for this (--plain).
    # shellcheck disable=SC2086 # an option or none
    attend setpriv --pdeathsig KILL parallel --plain --will-cite $bar --jobs "${2:-$(nproc)}" \
        --joblog "+$CLASS_FOLDER/joblog" --tmpdir "$CLASS_WORK-parallel" \
        'exec setpriv --pdeathsig KILL tests/class/grading/grade_one.sh {}' :::: "$1"
}

# engine_end: nothing of a dead run is alive, as the lock is ours.
engine_end() { :; }
