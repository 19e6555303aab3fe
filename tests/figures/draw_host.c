// 00-host-device.svg: what the host asks for, in which order the device does it, and who waits.
#include "figures2d.h"

// Three columns, host, queue and device; rows of boxes. Pixels.
enum { HOST = 24, QUEUE = 372, DEVICE = 720, BOX_WIDTH = 280, BOX_HEIGHT = 64, HEIGHT = 500 };
enum { FIRST = 104, SECOND = 204, THIRD = 334 };
#define LINE "stroke=\"" SVG_BLACK "\" stroke-width=\"3\""

static void box_draw(FILE *file, int left, int top, const char *ink, const char *code,
                     const char *words)
{
    char look[80];
    snprintf(look, sizeof look, "fill=\"%s\" stroke=\"" SVG_BLACK "\" stroke-width=\"2\"", ink);
    svg_box(file, left, top, BOX_WIDTH, BOX_HEIGHT, look);
    svg_text(file, left + BOX_WIDTH / 2.0, top + 27, SVG_MIDDLE, "", "%s", code);
    svg_text(file, left + BOX_WIDTH / 2.0, top + 51, SVG_MIDDLE, "", "%s", words);
}

static void arrow_draw(FILE *file, int left, int top, int right, const char *look)
{
    svg_arrow(file, left, top + BOX_HEIGHT / 2.0, right, top + BOX_HEIGHT / 2.0, look);
}

void draw_host(FILE *file, const Followed *followed)
{
    (void)followed;
    svg_begin(file, HEIGHT, "Host, queue and device",
              "Three columns. The host sets the kernel's arguments, puts a launch into the queue "
              "and goes on, puts a read into the queue and waits. The device takes the two in "
              "order: it runs the kernel once per pixel, then sends the picture back to the host.");
    svg_title(file, HOST, 44, SVG_LEFT, "", "Host: your program in C");
    svg_title(file, QUEUE, 44, SVG_LEFT, "", "Queue: in order");
    svg_title(file, DEVICE, 44, SVG_LEFT, "", "Device: GPU or CPU");
    svg_text(file, HOST, 72, SVG_LEFT, "fill=\"" SVG_GREY "\"", "render.c");
    svg_text(file, DEVICE, 72, SVG_LEFT, "fill=\"" SVG_GREY "\"", "gradient.cl");

    box_draw(file, HOST, FIRST, "#ffffff", "set_arguments", "what the kernel gets");
    box_draw(file, HOST, SECOND, "#ffffff", "enqueue_pixels", "launch, do not wait");
    box_draw(file, HOST, THIRD, "#ffffff", "read_back", "ask for the picture, wait");
    box_draw(file, QUEUE, SECOND, SVG_PALE, "1: launch", "the kernel");
    box_draw(file, QUEUE, THIRD, SVG_PALE, "2: read", "the image");
    box_draw(file, DEVICE, SECOND, SVG_SKY, "one work-item per pixel", "writes one colour");
    box_draw(file, DEVICE, THIRD, SVG_SKY, "the image", "is complete: copy it");
    const int tops[] = {SECOND, THIRD};
    for (int i = 0; i < 2; i++) {
        arrow_draw(file, HOST + BOX_WIDTH, tops[i], QUEUE - 8, "stroke-width=\"3\"");
        arrow_draw(file, QUEUE + BOX_WIDTH, tops[i], DEVICE - 8, "stroke-width=\"3\"");
    }
    svg_arrow(file, DEVICE + BOX_WIDTH / 2.0, SECOND + BOX_HEIGHT, DEVICE + BOX_WIDTH / 2.0,
              THIRD - 8, "stroke-width=\"3\"");

    // The way back.
    const double host_x = HOST + BOX_WIDTH / 2.0, device_x = DEVICE + BOX_WIDTH / 2.0;
    const double end = THIRD + BOX_HEIGHT, bottom = end + 34;
    svg_line(file, device_x, end, device_x, bottom, LINE);
    svg_line(file, device_x, bottom, host_x, bottom, LINE);
    svg_arrow(file, host_x, bottom, host_x, end + 8, "stroke-width=\"3\"");
    svg_text(file, QUEUE + BOX_WIDTH / 2.0, bottom + 32, SVG_MIDDLE, "",
             "the picture comes back; only now read_back returns");
    svg_end(file);
}
