#!/bin/sh
# attack: a manifest that gives 100 points, a Makefile, a compiler and headers of its own
# score: 0
# named: Makefile
cp "@COURSE@/labs/02-kdtree-2d-build/kdtree2d_build.c" .
sed -i 's/: [0-9][0-9]*/: 1000/' lab.json
printf 'all:\n\techo LEAK""ED\n' | tee Makefile GNUmakefile >makefile
printf '#!/bin/sh\necho LEAK""ED\n' | tee gcc grade >configure
chmod +x gcc grade configure
mkdir -p common solutions/02-kdtree-2d-build .git/hooks
echo '#error LEAKED' | tee common/tree2d.h stdio.h kdtree2d_build.h \
    >solutions/02-kdtree-2d-build/kdtree2d_build.c
