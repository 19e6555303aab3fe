// Writing HTML that nothing can break out of: one page in one file, without scripts or anything to
// fetch, whatever the text in it says.
#ifndef GRADER_HTML_H
#define GRADER_HTML_H

#include <stddef.h>
#include <stdio.h>

// Everything up to and including <main>: a policy that lets no script run and nothing be fetched,
// the title and the style sheet. What fails in any of these functions marks the stream.
void html_page_begin(FILE *page, const char *title);
void html_page_end(FILE *page);

// The same for a page that shows pictures beside it or in folders below it.
void html_album_begin(FILE *page, const char *title);

// The same for a page about one's own work that loads itself anew when there is news: when news.js
// beside it calls news() with another number than this.
void html_followed_begin(FILE *page, const char *title, int number);

// A template: %s is one line of any text, as html_line() writes it; %d, %.1f and %% are printf's,
// and others there are not. What stands around them is markup of ours.
__attribute__((format(printf, 2, 3))) void html_write(FILE *page, const char *template, ...);

// One line of any text, cleaned (clean_text.h) and escaped; also fit between double quotes, and in
// XML.
void html_line(FILE *page, const char *line);

// A message of any text, as a paragraph, or as a log that keeps its columns when it has several
// lines. Nothing when it is empty.
void html_message(FILE *page, const char *message);

// A bar filled to points / max_points, and red, amber or green by it.
void html_score_bar(FILE *page, int points, int max_points);

// An address "data:image/...;base64,...", whole: nothing where the text is anything else.
void html_picture_uri(FILE *page, const char *uri);

// A file's bytes as "data:type;base64,...".
void html_file_uri(FILE *page, const char *type, const void *bytes, size_t n_bytes);

#endif
