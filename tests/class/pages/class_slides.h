// class-slides.html: the most frequent mistakes of a class, for the next lecture.
#ifndef CLASS_CLASS_SLIDES_H
#define CLASS_CLASS_SLIDES_H

#include "gradebook.h"

// Write the slides: how the class did, then a slide for each of the five mistakes that most
// students made, with the check's hint, and a pair of pictures of one of them. No name is on them,
// and no text that a student wrote. Whole or not at all; returns 0, or -1 after one message.
int gradebook_slides(const Gradebook *gradebook, const char *path);

#endif
