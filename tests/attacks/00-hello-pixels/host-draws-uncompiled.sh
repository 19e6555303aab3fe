#!/bin/sh
# attack: as host-draws-and-ends, but another answer does not compile, so that answers are tried alone
# score: 40
# named: tested alone
sed 's|@''COURSE@|@COURSE@|g' "@COURSE@/tests/attacks/00-hello-pixels/host-draws-and-ends.sh" | sh
sed -i -e '/atexit(end_early)/d' -e '/END set_arguments/i no such type;' render.c
