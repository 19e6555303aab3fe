// The style sheet of every page that the grader writes.
#ifndef GRADER_HTML_STYLE_H
#define GRADER_HTML_STYLE_H

extern const char html_style[];

#endif
