#!/bin/sh
# Tables and plots of what the benches have measured.
#
#     tests/bench/tables.sh [FOLDER]
#
# FOLDER (build/bench) holds the CSV files of one or more benches (bench.h). Prints the tables of
# tables.sql, and writes its medians into medians.tsv and the plots beside it. Run it in the top folder.
set -e
folder=${1:-build/bench}
measured=$(cd "$folder" && ls bench2d.csv bench3d.csv bench_tricks.csv bench_builds.csv bench_watch.csv 2>/dev/null) || true
if [ -z "$measured" ]; then
    echo "tables.sh: $folder: found no CSV file of a bench" >&2
    exit 1
fi
{
    echo 'CREATE TABLE measured (scene TEXT, what TEXT, quantity TEXT, round INTEGER, value REAL);'
    for file in $measured; do
        echo ".import --csv --skip 1 '$folder/$file' measured"
    done
    cat tests/bench/tables.sql
    echo '.mode tabs'
    echo '.headers on'
    echo ".once '$folder/medians.tsv'"
    echo 'SELECT scene, elements, what, quantity, median, smallest, largest FROM medians ORDER BY elements;'
} | sqlite3 -bail
command -v gnuplot >/dev/null || { echo "no plots: gnuplot is not installed" && exit 0; }
for bench in bench2d bench3d bench_builds; do
    if [ -e "$folder/$bench.csv" ]; then
        gnuplot -e "folder = '$folder'" "tests/bench/$bench.gnuplot"
        echo "The plot: $folder/$bench.svg"
    fi
done
