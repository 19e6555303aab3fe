#!/bin/sh
# attack: two tasks are wrong, and the second calls the first: what is found where it is tried alone is a stub's work
# score: 40
# named: half-open|swapped|goes on with node
# never: tested alone: [^"]*getContainingChild was called
sed -e 's/x >= box.minX && x < box.maxX/x > box.minX \&\& x <= box.maxX/' \
    -e 's/getContainingChild(x, y, id,/getContainingChild(x - 1, y - 1, id,/' implicit2DRenderer_KD.cl >changed
mv changed implicit2DRenderer_KD.cl
