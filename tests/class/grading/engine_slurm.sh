# shellcheck shell=sh
# Spreading a class over a Slurm cluster, as job arrays (see grade_class.sh).
#
# The course's folder and the output folder must be the same on every node, and the grader's
# packages installed there.

slurm_name=grade-class-${CLASS_WORK##*-}

# engine_check: can it work here?
engine_check() {
    command -v sbatch >/dev/null || die "sbatch is missing: ENGINE=slurm needs a Slurm cluster"
    sinfo >/dev/null || die "this machine's Slurm does not answer"
}

# engine_run LIST [JOBS]: grade_one.sh for each line of the file LIST. An array has as many tasks as
# the cluster allows.
engine_run() {
    most=$(scontrol show config | awk '$1 == "MaxArraySize" { print $3 - 1 }')
    rm -f "$1".*
    split -l "${most:-1000}" -d -a 4 "$1" "$1."
    for block in "$1".*; do
        # It ends with the driver; the array is ended at the next start, or by engine_end.
        # shellcheck disable=SC2016 # for the task
        attend setpriv --pdeathsig KILL sbatch --wait --parsable --job-name="$slurm_name" \
            --array="1-$(wc -l <"$block")${2:+%$2}" --ntasks=1 --export=ALL --chdir="$PWD" \
            --open-mode=append --output="$CLASS_FOLDER/logs/slurm.txt" --wrap \
            'exec tests/class/grading/grade_one.sh $(sed -n "${SLURM_ARRAY_TASK_ID}p" "'"$block"'")' \
            >"$CLASS_FOLDER/slurm-job" || :
        # How its tasks ended is seen by their results.
        [ -s "$CLASS_FOLDER/slurm-job" ] || die "Slurm did not take the jobs"
    done
    rm -f "$1".*
}

# engine_end: end the arrays of this class, also a dead run's. Fails where Slurm does not answer.
engine_end() {
    scancel --quiet --name="$slurm_name" || return
    tries=120
    while [ $tries -gt 0 ] && [ -n "$(squeue --noheader --name="$slurm_name")" ]; do
        sleep 0.5
        tries=$((tries - 1))
    done
    [ $tries -gt 0 ]
}
