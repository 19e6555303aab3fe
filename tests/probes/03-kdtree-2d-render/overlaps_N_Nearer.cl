// Lab 01's overlaps_N_Nearer as the probe of lab 03 has it: it never takes a circle with the alpha
// UNTAKEN. Nothing else tells such a circle from others, so who tests circles in another way than
// by this function takes it.
#include "jobs_03.h"

#define overlaps_N_Nearer taken_N_Nearer
#include "01-naive-2d/overlaps_N_Nearer.cl"
#undef overlaps_N_Nearer

int overlaps_N_Nearer(int x, int y, Circle circle, float minDepth, Work *work)
{
    return taken_N_Nearer(x, y, circle, minDepth, work) && circle.a != UNTAKEN;
}
