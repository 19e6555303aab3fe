// Lab 08 has another tree and lab 07's kernel: its steps are written down as that one's.
//
// Started by record.c.
#include "07-kdtree-3d-trace.cl"
