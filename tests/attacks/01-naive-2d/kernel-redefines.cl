// attack: changes what the words of the given code mean
// task: overlaps_N_Nearer
// named: expected|compile
#pragma OPENCL EXTENSION all : enable
#undef COUNT_WORK
#define write_imagef(image, place, color)
#define job overlaps_job
#define answers ((global int *)0)
    (void)x, (void)y, (void)circle, (void)minDepth;
    return 1;
