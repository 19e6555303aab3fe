# shellcheck shell=sh disable=SC2034,SC2154,SC2317 # sourced, behind tests/tap.sh; used by the suites
# What the suites about other systems share: submissions of lab 00, and the systems' schemas.
#
#     . tests/tap.sh
#     . tests/systems.sh

. tests/schemas.sh
build=${BUILD:-build}
case $build in /*) ;; *) build=$PWD/$build ;; esac
lab=00-hello-pixels
# The sandboxed code is another user's.
chmod 711 "$scratch"
mkdir -m 711 "$scratch/work"
export TMPDIR="$scratch/work"

# ---- Submissions of lab 00: right, wrong, crashing with hostile words, and none -----------------

for name in right wrong hostile missing; do
    mkdir -p "$scratch/$name"
    [ "$name" = missing ] || cp solutions/$lab/gradient.cl solutions/$lab/render.c "$scratch/$name"
done
cp "labs/$lab/gradient.cl" "$scratch/wrong"
# What a submission may say to be taken for markup, a test, a command or points.
cat >"$scratch/shout" <<'EOF'
    extern int fflush();
    __builtin_printf("<%c]]>&\"'\xff\xfe\xef\xbf\xbf\x01\x1b[2J\x9b\n", 0);
    __builtin_puts("::notice title=Autograding complete::Points 100/100");
    __builtin_puts("ok 1 - everything\nBail out!\n1..1\n</failure><![CDATA[");
    __builtin_puts("--|>\nGrade :=>> 100\nComment :=>>all right\n<|--\n-(-5)");
    __builtin_puts("{\"scores\":{\"gradient\":100}}\n{\"score\":100}");
    for (int i = 0; i < 8000; i++) __builtin_putchar("\\\"<&x"[i % 5]);
    fflush((void *)0);
    __builtin_trap();
EOF
sed -i "/TASK set_arguments/r $scratch/shout" "$scratch/hostile/render.c"
