// One frame: the world drawn by a lab's kernel, and what each pixel of it cost.
//
// Read next: view.c, which shows it.
#ifndef VIEW_FRAME_H
#define VIEW_FRAME_H

#include "image.h"
#include "world.h"

// The counters of kernels/work.h over all pixels of a frame, in the order of Work.
enum { N_COUNTERS = 4 };
typedef struct WorkFigures {
    double mean[N_COUNTERS];
    u32 most[N_COUNTERS];
    u32 most_steps;  // of one pixel: the brightest colour of the heat map
} WorkFigures;

typedef struct Frame {
    const WorldKernel *kernel;         // what draws it
    cl_kernel built[LAB_MAX_KERNELS];  // LAB_DRAWS, LAB_COUNTS
    cl_mem d_work;
    Image picture;   // as the kernel drew it
    double draw_ms;  // from its launch to its end
    Work *h_work;    // [height][width]
    WorkFigures work;
} Frame;

// Make room for frames of a world. Returns 0, or -1 after one message on stderr. Release with
// frame_close(), which accepts a zeroed Frame.
int frame_open(Frame *frame, const World *world);
void frame_close(Frame *frame);

// Draw with this kernel from now on: it is built, once to draw and once to count. Returns 0; or -1
// after messages on stderr, and the kernel before stays.
int frame_use(Frame *frame, const World *world, const WorldKernel *kernel);

// Draw the world; wait for the picture and copy it to the host.
void frame_draw(Frame *frame, const World *world);

// Draw it once more with the kernel that counts; the picture stays as it is.
void frame_count(Frame *frame, const World *world);

// The colours of a heat map of the counted work, as `--heat-map` of the labs saves it.
//   heat   out; a picture of the frame's size
void frame_heat_map(const Frame *frame, Image *heat);

#endif
