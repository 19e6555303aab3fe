#!/bin/sh
# attack: file names with blanks, newlines, quotes, options and 255 bytes, and files that are none
# score: 0
# named: not looked at
cp "@COURSE@/labs/02-kdtree-2d-build/kdtree2d_build.c" .
touch 'a name with blanks' "a name
with a newline" ./-rf ./--help '...' '..x'
# shellcheck disable=SC2016 # these are meant to be names
touch '$(id)' '`id`' '<script>alert(1)<' "it's" '"quoted"' '%n%s'
touch "$(printf '\033[2Jescape')" "$(printf '%0255d' 0)" "$(printf '\377\376')"
mkdir -p '.. ' 'kdtree2d_build.c '
ln -s / root-of-all
ln -s ../../../../../../../../../../etc/shadow shadow
mkfifo pipe
