#!/bin/sh
# Cut the skeletons of all labs, or of one, from solutions/ into a folder.
#
#     tests/tools/cut_labs.sh HOLES-TOOL FOLDER [LAB]
#
# Sources lose what stands in their holes, texts the comments that say where a number is from (slides-notes/make);
# every other file is copied as it is. What is no longer in solutions/ disappears.
set -eu

holes=$1
folder=$2
from=solutions${3:+/$3}

rm -rf "$folder.new"
mkdir -p "$folder.new"
git ls-files -z --cached --others --exclude-standard "$from" 2>/dev/null |
    tr '\0' '\n' >"$folder.new/.list"
[ -s "$folder.new/.list" ] || find "$from" -type f >"$folder.new/.list"
while IFS= read -r file; do
    [ -f "$file" ] || continue
    copy=$folder.new/${file#solutions/}
    mkdir -p "$(dirname "$copy")"
    case $file in
    *.c | *.h | *.cl) "$holes" cut "$file" >"$copy" ;;
    *.md) sed '/^<!-- [0-9][0-9]-[a-z0-9-]*: printed -->$/d; s/<!-- [^>]* -->//g' "$file" >"$copy" ;;
    *) cp "$file" "$copy" ;;
    esac
done <"$folder.new/.list"
rm "$folder.new/.list"
rm -rf "$folder"
mv "$folder.new" "$folder"
