// A window to draw into (see window.h). It is drawn in memory, in a canvas, and copied to the
// screen whole: no graphics card is needed, and what is saved is what was shown.
//
// Read next: panel.c.
#include "window.h"

#include "complain.h"

#include <math.h>
#include <stdlib.h>

// Every character is equally wide, so that columns of numbers stand under each other. From the
// package fonts-dejavu-core.
static const char FONT_FILE[] = "/usr/share/fonts/truetype/dejavu/DejaVuSansMono.ttf";
enum { FONT_SIZE = 13, BITS_PER_PIXEL = 32 };

// Open all but the title. Returns NULL, or what is wrong.
static const char *open_parts(Window *window, const char *title, int width, int height)
{
    // Left to itself SDL goes on without a display, where nobody would see anything.
    const int has_only_wayland = getenv("DISPLAY") == NULL && getenv("WAYLAND_DISPLAY") != NULL;
    SDL_SetHint(SDL_HINT_VIDEODRIVER, has_only_wayland ? "wayland" : "x11");
    if (SDL_Init(SDL_INIT_VIDEO) != 0 || TTF_Init() != 0) {
        return SDL_GetError();
    }
    window->font = TTF_OpenFont(FONT_FILE, FONT_SIZE);
    if (window->font == NULL) {
        return TTF_GetError();
    }
    window->line_height = TTF_FontLineSkip(window->font);
    TTF_SizeUTF8(window->font, "m", &window->char_width, NULL);
    // Without alpha, which nothing here writes: SDL would blend the canvas with what is on the
    // screen.
    window->canvas =
        SDL_CreateRGBSurfaceWithFormat(0, width, height, BITS_PER_PIXEL, SDL_PIXELFORMAT_RGB888);
    window->shown = SDL_CreateWindow(title, SDL_WINDOWPOS_CENTERED, SDL_WINDOWPOS_CENTERED, width,
                                     height, SDL_WINDOW_RESIZABLE);
    return window->canvas == NULL || window->shown == NULL ? SDL_GetError() : NULL;
}

int window_open(Window *window, const char *title, int width, int height)
{
    *window = (Window){0};
    const char *fault = open_parts(window, title, width, height);
    if (fault == NULL) {
        return 0;
    }
    complain("%s: no window can be opened: %s; a display is needed (a desktop, or ssh -X), and the "
             "package fonts-dejavu-core",
             title, fault);
    window_close(window);
    return -1;
}

void window_close(Window *window)
{
    TTF_CloseFont(window->font);
    SDL_FreeSurface(window->canvas);
    SDL_DestroyWindow(window->shown);
    TTF_Quit();
    SDL_Quit();
    *window = (Window){0};
}

void window_fill(Window *window, Box box, Colour colour)
{
    SDL_FillRect(window->canvas, &box, colour);
}

void window_outline(Window *window, Box box, Colour colour)
{
    window_fill(window, (Box){box.x, box.y, box.w, 1}, colour);
    window_fill(window, (Box){box.x, box.y + box.h - 1, box.w, 1}, colour);
    window_fill(window, (Box){box.x, box.y, 1, box.h}, colour);
    window_fill(window, (Box){box.x + box.w - 1, box.y, 1, box.h}, colour);
}

void window_text(Window *window, Box box, Colour colour, const char *text)
{
    const SDL_Color ink = {colour >> 16 & 0xff, colour >> 8 & 0xff, colour & 0xff, 0xff};
    // Of nothing SDL makes no picture.
    SDL_Surface *drawn = text[0] != '\0' ? TTF_RenderUTF8_Blended(window->font, text, ink) : NULL;
    if (drawn != NULL) {
        const Box part = {0, 0, box.w, drawn->h};
        SDL_BlitSurface(drawn, &part, window->canvas, &box);
        SDL_FreeSurface(drawn);
    }
}

// A channel in 8 bits, as image.cpp rounds it for a .png; a NaN becomes 0.
static Uint32 channel_byte(float value)
{
    return (Uint32)lrintf((value > 0 ? fminf(value, 1) : 0) * 255);
}

static Uint32 *canvas_row(const Window *window, int y)
{
    return (Uint32 *)((char *)window->canvas->pixels + (size_t)y * (size_t)window->canvas->pitch);
}

void window_picture(Window *window, int x, int y, const Image *image)
{
    const float *pixel = image->pixels;
    for (int row = 0; row < image->height; row++) {
        Uint32 *shown = canvas_row(window, y + row) + x;
        for (int column = 0; column < image->width; column++, pixel += IMAGE_CHANNELS) {
            shown[column] =
                channel_byte(pixel[0]) << 16 | channel_byte(pixel[1]) << 8 | channel_byte(pixel[2]);
        }
    }
}

void window_show(Window *window)
{
    // SDL makes a new one when the window's size changes.
    SDL_Surface *screen = SDL_GetWindowSurface(window->shown);
    if (screen != NULL) {
        SDL_BlitScaled(window->canvas, NULL, screen, NULL);
        SDL_UpdateWindowSurface(window->shown);
    }
}

void window_to_canvas(const Window *window, int *x, int *y)
{
    int width, height;
    SDL_GetWindowSize(window->shown, &width, &height);
    *x = *x * window->canvas->w / width;
    *y = *y * window->canvas->h / height;
}

int window_save(const Window *window, const char *path)
{
    Image image;
    if (image_create(window->canvas->w, window->canvas->h, &image) != 0) {
        return -1;
    }
    float *pixel = image.pixels;
    for (int y = 0; y < image.height; y++) {
        const Uint32 *row = canvas_row(window, y);
        for (int x = 0; x < image.width; x++, pixel += IMAGE_CHANNELS) {
            pixel[0] = (float)(row[x] >> 16 & 0xff) / 255;
            pixel[1] = (float)(row[x] >> 8 & 0xff) / 255;
            pixel[2] = (float)(row[x] & 0xff) / 255;
            pixel[3] = 1;
        }
    }
    const int result = image_save(&image, path);
    image_free(&image);
    return result;
}
