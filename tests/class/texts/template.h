// An HTML page from a template, a file with named places (the language is Mustache's):
//
//     {{name}}                  the text or number of this name, as text (html.h)
//     {{{name}}}                the same as it is: markup of ours
//     {{#name}} ... {{/name}}   for each object of a list, for an object, or for anything else;
//                               names in it are those of the object first
//     {{^name}} ... {{/name}}   where there is nothing: no such name, false, "" or []
//
// In a list is_first, is_next (not the first) and is_last are true of its objects.
// A line with nothing but the begin or end of such a part is not written.
#ifndef CLASS_TEMPLATE_H
#define CLASS_TEMPLATE_H

#include "output_file.h"

#include <jansson.h>
#include <stdio.h>

// A template's text, which becomes a part of the program (so it depends on the file in tests.mk).
#define TEMPLATE(name, path)                                                                       \
    __asm__(".pushsection .rodata\n" #name ":\n.incbin \"" path "\"\n.byte 0\n.popsection");       \
    extern const char name[]

// Fill in a template. `values`: an object, which is released. Returns 0, or -1 after one message.
int template_write(FILE *page, const char *text, json_t *values);

// End the page's file: it is there whole or, where the template failed, as it was before. Returns
// as above.
int template_commit(OutputFile *output, int failed);

// Any text as a value; what is no text of one line is made one. NULL is "".
json_t *template_line(const char *text);

// Markup as a value: what `write` writes to a file in memory, given `about`.
json_t *template_markup(void (*write)(FILE *file, const void *about), const void *about);

// How full, as a bar (html_score_bar()).
json_t *template_bar(int points, int max_points);

#endif
