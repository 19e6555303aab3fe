// A window to draw into: pictures, boxes and text, by SDL. All that touches the screen is here.
//
// Read next: panel.c.
#ifndef VIEW_WINDOW_H
#define VIEW_WINDOW_H

#include "image.h"

#include <SDL.h>
#include <SDL_ttf.h>

typedef struct Window {
    SDL_Window *shown;
    SDL_Surface *canvas;  // what is drawn; of the size it was opened with, whatever the window's is
    TTF_Font *font;
    int line_height;  // of the text, pixels
    int char_width;   // every character's
} Window;

// Where a box stands on the canvas, pixels from its top left corner.
typedef SDL_Rect Box;

// A colour, 0xRRGGBB.
typedef Uint32 Colour;

// Open a window. Returns 0, or -1 after one message on stderr: there is no display, or no font.
// Close with window_close(), which accepts a zeroed Window.
int window_open(Window *window, const char *title, int width, int height);
void window_close(Window *window);

void window_fill(Window *window, Box box, Colour colour);

// A frame of 1 pixel inside the box.
void window_outline(Window *window, Box box, Colour colour);

// One line of text, cut off where the box ends.
void window_text(Window *window, Box box, Colour colour, const char *text);

// A picture, pixel for pixel, with its top left corner at x, y: as image_save() makes a .png of it.
void window_picture(Window *window, int x, int y, const Image *image);

// Show what was drawn; it fills the window, whatever its size.
void window_show(Window *window);

// Where on the canvas is this point of the window?
void window_to_canvas(const Window *window, int *x, int *y);

// Save what the window shows, canvas size, .png or .exr. Returns 0, or -1 after one message.
int window_save(const Window *window, const char *path);

#endif
