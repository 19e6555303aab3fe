// 04-camera.svg: eye, axes, display and a pixel's ray.
#include "figures3d.h"

#include "oracle3d.h"

// The display's size in pixels, and the pixel whose ray is drawn.
enum { COLUMNS = 8, ROWS = 6, PIXEL_X = 1, PIXEL_Y = 1, HEIGHT = 590 };
static const double FOV = 1;

static const OracleRules3D RIGHT = {0};

// A point seen from the eye (right, up, forward) in the drawing: forward goes to the right, `right`
// to the lower right.
static double draw_x(OracleVector p)
{
    return 190 + 470 * p.z + 200 * p.x;
}

static double draw_y(OracleVector p)
{
    return 360 - 330 * p.y + 150 * p.x - 60 * p.z;
}

static void edge_draw(FILE *file, OracleVector from, OracleVector to, const char *look)
{
    svg_line(file, draw_x(from), draw_y(from), draw_x(to), draw_y(to), look);
}

static void axis_draw(FILE *file, OracleVector to, const char *name, double dx, double dy)
{
    svg_arrow(file, draw_x((OracleVector){0}), draw_y((OracleVector){0}), draw_x(to), draw_y(to),
              "stroke-width=\"4\"");
    svg_text(file, draw_x(to) + dx, draw_y(to) + dy, SVG_MIDDLE, SVG_HALO, "%s", name);
}

// A pixel's corner on the display: half a pixel from its middle.
static OracleVector corner(int x, int y)
{
    const OracleVector middle = oracle3d_display(x, y, COLUMNS, ROWS, FOV, &RIGHT);
    const double half = FOV / COLUMNS / 2;
    return (OracleVector){middle.x - half, middle.y + half, middle.z};
}

static void display_draw(FILE *file)
{
    for (int x = 0; x <= COLUMNS; x++) {
        edge_draw(file, corner(x, 0), corner(x, ROWS), "stroke=\"" SVG_GREY "\"");
    }
    for (int y = 0; y <= ROWS; y++) {
        edge_draw(file, corner(0, y), corner(COLUMNS, y), "stroke=\"" SVG_GREY "\"");
    }
    const OracleVector pixel[] = {corner(PIXEL_X, PIXEL_Y), corner(PIXEL_X + 1, PIXEL_Y),
                                  corner(PIXEL_X + 1, PIXEL_Y + 1), corner(PIXEL_X, PIXEL_Y + 1)};
    fputs("<polygon fill=\"" SVG_SAND "\" stroke=\"" SVG_BLACK "\" stroke-width=\"2\" points=\"",
          file);
    for (int i = 0; i < 4; i++) {
        fprintf(file, "%.1f,%.1f ", draw_x(pixel[i]), draw_y(pixel[i]));
    }
    fputs("\"/>\n", file);
    const OracleVector corners[] = {corner(0, 0), corner(COLUMNS, 0), corner(COLUMNS, ROWS),
                                    corner(0, ROWS)};
    for (int i = 0; i < 4; i++) {
        edge_draw(file, (OracleVector){0}, corners[i],
                  "stroke=\"" SVG_GREY "\" stroke-dasharray=\"5 5\"");
        edge_draw(file, corners[i], corners[(i + 1) % 4],
                  "stroke=\"" SVG_BLACK "\" stroke-width=\"3\"");
    }
}

void draw_camera(FILE *file, const Followed *followed)
{
    (void)followed;
    const OracleVector eye = {0},
                       pixel = oracle3d_display(PIXEL_X, PIXEL_Y, COLUMNS, ROWS, FOV, &RIGHT);
    svg_begin(
        file, HEIGHT, "The camera: eye, axes, display, and a pixel's ray",
        "From the eye three arrows at right angles: forward, right and up. At distance 1 before it "
        "stands the display, eight by six square pixels, as wide as the field of view, fov. The "
        "ray "
        "of a pixel goes from the eye through the pixel's middle and on.");
    svg_title(file, 24, 40, SVG_LEFT, "", "A pixel's ray goes through the middle of the pixel");
    display_draw(file);
    const OracleVector end = {1.4 * pixel.x, 1.4 * pixel.y, 1.4 * pixel.z};
    svg_arrow(file, draw_x(eye), draw_y(eye), draw_x(end), draw_y(end), "stroke-width=\"3\"");
    axis_draw(file, (OracleVector){0, 0, 0.6}, "forward", 0, 28);
    axis_draw(file, (OracleVector){0.6, 0, 0}, "right", 40, 8);
    axis_draw(file, (OracleVector){0, 0.6, 0}, "up", -26, 6);
    svg_circle(file, draw_x(eye), draw_y(eye), 10,
               "fill=\"#ffffff\" stroke=\"" SVG_BLACK "\" stroke-width=\"4\"");
    svg_text(file, draw_x(eye) - 22, draw_y(eye) + 8, SVG_RIGHT, "", "eye e");
    svg_circle(file, draw_x(pixel), draw_y(pixel), 5, "fill=\"" SVG_BLACK "\"");
    svg_text(file, draw_x(end) + 8, draw_y(end) + 6, SVG_LEFT, "", "ray e + t d");

    const OracleVector left = corner(0, ROWS), right = corner(COLUMNS, ROWS);
    svg_text(file, (draw_x(left) + draw_x(right)) / 2 - 100,
             (draw_y(left) + draw_y(right)) / 2 + 70, SVG_MIDDLE, SVG_HALO,
             "width fov, at distance 1");
    svg_text(file, 24, HEIGHT - 44, SVG_LEFT, "",
             "pixel (%d, %d) of %d x %d, fov = %g: on the display at (%.4g, %.4g),", PIXEL_X,
             PIXEL_Y, COLUMNS, ROWS, FOV, pixel.x, pixel.y);
    svg_text(file, 24, HEIGHT - 16, SVG_LEFT, "", "so d ~ %.4g · right + %.4g · up + forward",
             pixel.x, pixel.y);
    svg_end(file);
}
