// The pictures of an HTML report.
#ifndef GRADER_REPORT_PICTURES_H
#define GRADER_REPORT_PICTURES_H

#include "result.h"

#include <stdio.h>

// Write one scene's reference, the student's own picture and their difference side by side,
// embedded. What is missing is said in its place. Returns 0, or -1 after one message on stderr.
int report_pictures_write(FILE *page, const PictureResult *picture);

// Is the student's picture the reference? Drawings are not compared: they are never right.
int scene_is_right(const PictureResult *picture);

// Write a picture as PNG, or in its place a drawing, as a data: URI. Returns 0, or -1 after one
// message on stderr.
int picture_uri_write(FILE *page, const Image *image, const char *svg);

#endif
