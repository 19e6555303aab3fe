#!/bin/sh
# The bench's tables (../bench/tables.sql): what they say of times that are made up.
. tests/tap.sh

# What tables.sh needs, without gnuplot, which draws nothing of so few points.
mkdir "$scratch/bin"
for tool in cat ls sqlite3; do
    ln -s "$(command -v $tool)" "$scratch/bin/$tool"
done

# tables: makes tables of the rows "SCENE;WHAT;QUANTITY;ROUND;VALUE" on stdin.
tables() {
    { echo 'scene,what,quantity,round,value' && sed 's/;/","/g; s/.*/"&"/'; } >"$scratch/bench3d.csv"
    PATH="$scratch/bin" tests/bench/tables.sh "$scratch" 2>&1 | sed 's/ *│ */│/g' >"$scratch/tables"
}

# expect NAME ROW: passes if the tables have that row, or that part of one.
expect() {
    grep -qF "│$2│" "$scratch/tables"
    ok $? "$1" "expected │$2│ in
$(cat "$scratch/tables")"
}

# ---- Medians and ratios -------------------------------------------------------------------------

tables <<END
sphereflake;;rays;0;1000000
sphereflake;naive;frame;0;10
sphereflake;naive;frame;1;20
sphereflake;naive;frame;2;60
sphereflake;kd-tree;frame;0;1
sphereflake;kd-tree;frame;1;3
sphereflake;kd-tree;frame;1;5
sphereflake;kd-tree;frame;2;6
sphereflake;tiles;frame;0;2
sphereflake;tiles;frame;1;2
sphereflake;tiles;frame;2;2
sphereflake;rtcIntersect4;frame;0;6
sphereflake;rtcIntersect4;frame;1;6
sphereflake;rtcIntersect4;frame;2;6
sphereflake;rtcIntersect8;frame;0;9
sphereflake;rtcIntersect8;frame;1;4
sphereflake;rtcIntersect8;frame;2;4
END
expect "a median, with the smallest and the largest" 'sphereflake│naive│frame│3│20 (10 to 60)│50│50'
expect "of an even number the two in the middle count" 'sphereflake│kd-tree│frame│4│4 (1 to 6)│250│250'
expect "a ratio is the median of the rounds' ratios" 'sphereflake│naive / kd-tree│10 (5 to 10)'
expect "Embree's best call has the smallest median" 'sphereflake│Embree, best call / tiles│2 (2 to 4.5)'

# ---- From how many spheres on -------------------------------------------------------------------

# moving NAIVE...: rows of two rounds of scenes of 1, 10, 100 and so on spheres: the naive frame takes so long, in
# the second round twice as long; the tree of lab 06 takes 10 ms in all.
moving() {
    n=1
    for naive; do
        scene=random:n=$n
        echo "$scene;;elements;0;$n"
        for round in 0 1; do
            echo "$scene;naive;frame;$round;$(echo "$naive $round" | awk '{ print $1 * (1 + $2) }')"
            printf '%s\n' "$scene;kd-tree;build;$round;2" "$scene;kd-tree;copy;$round;3" "$scene;kd-tree;frame;$round;5"
        done
        n=${n}0
    done
}
faster="lab 06's tree and lab 07's kernel are faster than the naive kernel"

moving 1 10 100 1000 | tables
expect "a frame is building, copying and drawing" 'random:n=100│kd-tree│moving frame│2│10 (10 to 10)││'
expect "a tree pays where the curves cross" "$faster│7.5 (5 to 10)│Inf (Inf to Inf)"
moving 20 5 | tables
expect "a tree may pay for few spheres only" "$faster│1 (1 to 1)│6.6 (3.2 to 10)"
moving 1 2 | tables
expect "a tree may never pay" "$faster│Inf (Inf to Inf)│Inf (Inf to Inf)"
moving 4 20 20 9.99 10.01 | tables
expect "of several spans the longest counts" "$faster│2.55 (1.4 to 3.7)│Inf (1000 to Inf)"

# ---- How builds grow ----------------------------------------------------------------------------

# Every build takes 2 N log2 N + 10 N ns: 30, 34 and 38 for each element. One law for it is
# (1/30 + 1/34 + 1/38) / (1/30^2 + 1/34^2 + 1/38^2) = 33.37 for each, and 38 is off by 12 % of itself.
for n in 1024 4096 16384; do
    echo "$n elements;lab 06;elements;0;$n"
    echo "$n elements;lab 06;build;0;$(echo $n | awk '{ print $1 * (2 * log($1) / log(2) + 10) / 1e6 }')"
    echo "$n elements;lab 06;handed on;0;$((9 * n))"
done | tables
expect "shares of an element" 'lab 06│4096│34│9.0'
expect "N log N: factors, and how far the farthest case is off" 'build│lab 06│N log N│2.00│10.00│0 %'
expect "N: the same" 'build│lab 06│N│0.00│33.37│12 %'
expect "what is linear has no part that grows" 'handed on│lab 06│N log N│0.00│9.00│0 %'

# ---- The watch ----------------------------------------------------------------------------------

tables <<END
watch 03;natively first;verdict;1;300
watch 03;natively first;verdict;2;500
watch 03;natively first;verdict, processor;1;250
watch 03;natively first;round;1;2000
watch 03;natively first;round, processor;1;2300
END
expect "from a save to a verdict" '03│natively first│400 (300 to 500)│250│2000│2300'

rm "$scratch/bench3d.csv"
PATH="$scratch/bin" tests/bench/tables.sh "$scratch" 2>&1 | grep -q 'found no CSV file of a bench'
ok $? "without a file there is a message"

finish
