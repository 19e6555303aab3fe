#!/bin/sh
# The same class through Slurm: a cluster of one machine, started here, gives the same gradebook to
# the byte, and a run that was killed leaves no job in it.
#
#     sh tests/suites/slurm.sh      from the top folder, after `make tests`
set -u
. tests/tap.sh

build=${BUILD:-build}
case $build in /*) ;; *) build=$PWD/$build ;; esac
for program in sbatch slurmctld slurmd munged; do
    if ! command -v $program >/dev/null; then
        skip "a class through Slurm" "$program is missing: packages slurm-wlm and munge"
        finish
        exit
    fi
done
if [ "$(id -u)" -ne 0 ]; then
    skip "a class through Slurm" "starting a cluster needs root"
    finish
    exit
fi

# shellcheck disable=SC2154 # set by tap.sh
chmod 711 "$scratch"
mkdir -m 711 "$scratch/w"
export TMPDIR="$scratch/w"

# ---- A cluster of one machine -------------------------------------------------------------------

cluster=$scratch/cluster
export SLURM_CONF="$cluster/slurm.conf"

# is_free PORT: does nothing on this machine use it?
is_free() { ! grep -q -i "^ *[0-9]*: [0-9A-F]*:$(printf %04X "$1") " /proc/net/tcp /proc/net/tcp6; }
port=20000
until is_free $port && is_free $((port + 1)); do port=$((port + 2)); done

cluster_start() {
    mkdir -p "$cluster/state" "$cluster/spool"
    (umask 077 && head -c 64 /dev/urandom >"$cluster/munge.key")
    # Without systemd and cgroups, and on loopback only.
    cat >"$SLURM_CONF" <<END
ClusterName=suite
SlurmctldHost=localhost(127.0.0.1)
SlurmctldPort=$port
SlurmdPort=$((port + 1))
CommunicationParameters=NoCtldInAddrAny,NoInAddrAny
SlurmUser=root
AuthType=auth/munge
AuthInfo=socket=$cluster/munge.socket
CredType=cred/munge
StateSaveLocation=$cluster/state
SlurmdSpoolDir=$cluster/spool
SlurmctldPidFile=$cluster/slurmctld.pid
SlurmdPidFile=$cluster/slurmd.pid
SlurmctldLogFile=$cluster/slurmctld.log
SlurmdLogFile=$cluster/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
MpiDefault=none
MaxArraySize=4
MinJobAge=2
KillWait=1
SchedulerParameters=sched_min_interval=1,batch_sched_delay=0,bf_interval=1
NodeName=localhost NodeAddr=127.0.0.1 CPUs=$(nproc) State=UNKNOWN
PartitionName=all Nodes=localhost Default=YES State=UP
END
    munged --force --key-file="$cluster/munge.key" --socket="$cluster/munge.socket" \
        --pid-file="$cluster/munged.pid" --log-file="$cluster/munged.log" \
        --seed-file="$cluster/munge.seed" &&
        slurmctld -f "$SLURM_CONF" && slurmd -f "$SLURM_CONF" -N localhost &&
        await is_idle
}

cluster_end() {
    for program in slurmd slurmctld munged; do
        [ ! -s "$cluster/$program.pid" ] || kill "$(cat "$cluster/$program.pid")" 2>/dev/null
    done
    await has_ended 2>/dev/null
}
# shellcheck disable=SC2013 # words
has_ended() {
    for process in $(cat "$cluster"/*.pid); do ! kill -0 "$process" || return 1; done
}

is_idle() { sinfo --noheader --format %t 2>/dev/null | grep -q idle; }
is_empty() { [ -z "$(squeue --noheader)" ]; }

trap 'cluster_end; rm -rf "$scratch"' EXIT
if ! cluster_start >"$scratch/said" 2>&1; then
    ok 1 "a cluster of one machine starts" "$(tail -n 5 "$scratch/said" "$cluster"/*.log)"
    finish
    exit
fi
ok 0 "a cluster of one machine starts"

# ---- The same class, twice ----------------------------------------------------------------------

lab=00-hello-pixels
class=$scratch/class
mkdir "$class"
cp -R solutions/$lab "$class/ada"
cp -R labs/$lab "$class/bob and 'co'"
cp -R solutions/$lab "$class/carol"
rm "$class/carol/gradient.cl"
cp -R solutions/$lab "$class/dan"
ln -s /etc "$class/eve"

# run OUTPUT OPTION...: the driver, with its messages in $scratch/said.
run() {
    output=$1
    shift
    tests/class/grading/grade_class.sh --build "$build" --lab 0 --submissions "$class" --output "$output" \
        --seed 5 "$@" >"$scratch/said" 2>&1 </dev/null
    [ $? -eq 1 ] || { cat "$scratch/said"; return 1; }
}

# More submissions than an array of this cluster has tasks; the link is not graded: status 1.
check "through Slurm" run "$scratch/slurm" --engine slurm
check "through GNU parallel" run "$scratch/parallel" --engine parallel
for file in gradebook.csv gradebook.json class.html; do
    check "$file is the same to the byte" cmp "$scratch/slurm/$file" "$scratch/parallel/$file"
done

# ---- Killed -------------------------------------------------------------------------------------

has_started() { squeue --noheader --states=RUNNING | grep -q .; }
run "$scratch/killed" --engine slurm &
driver=$!
check "a task runs" await has_started
# shellcheck disable=SC2046 # the driver and its shell
kill -9 $(cat "/proc/$driver/task/$driver/children") $driver
check "killed, and taken up by GNU parallel" run "$scratch/killed" --engine parallel
check "no job is left in the cluster" await is_empty
check "the gradebook is the same" cmp "$scratch/slurm/gradebook.csv" "$scratch/killed/gradebook.csv"
check "nothing stays behind in TMPDIR" test -z "$(ls -A "$TMPDIR")"

finish
