// Writing HTML that nothing can break out of (see html.h).
//
// The page works without a script, and its policy forbids them, so that escaping is not the only
// thing between a student's text and an instructor's browser. Read next: html_style.c,
// report_html.c.
#include "html.h"

#include "clean_text.h"
#include "html_style.h"

#include <limits.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

static void escaped_write(FILE *page, const char *text)
{
    static const char *const entities[UCHAR_MAX + 1] = {
        ['&'] = "&amp;", ['<'] = "&lt;", ['>'] = "&gt;", ['"'] = "&quot;", ['\''] = "&#39;"};
    for (; *text != '\0'; text++) {
        const char *entity = entities[(unsigned char)*text];
        if (entity != NULL) {
            fputs(entity, page);
        } else {
            fputc(*text, page);
        }
    }
}

void html_line(FILE *page, const char *line)
{
    char *clean = line_clean(line);
    escaped_write(page, clean);
    free(clean);
}

void html_write(FILE *page, const char *template, ...)
{
    va_list values;
    va_start(values, template);
    for (const char *at = template; *at != '\0'; at++) {
        if (*at != '%') {
            fputc(*at, page);
        } else if (*++at == 's') {
            html_line(page, va_arg(values, const char *));
        } else if (*at == 'd') {
            fprintf(page, "%d", va_arg(values, int));
        } else if (strncmp(at, ".1f", 3) == 0) {
            fprintf(page, "%.1f", va_arg(values, double));
            at += 2;
        } else if (*at == '%') {
            fputc('%', page);
        } else {
            abort();  // a template of ours that is wrong
        }
    }
    va_end(values);
}

void html_message(FILE *page, const char *message)
{
    char *clean = message_clean(message);
    int is_log = strchr(clean, '\n') != NULL;
    if (clean[0] != '\0') {
        fputs(is_log ? "<pre class=\"log\">" : "<p class=\"message\">", page);
        escaped_write(page, clean);
        fputs(is_log ? "</pre>\n" : "</p>\n", page);
    }
    free(clean);
}

// The page's own policy: what it may load.
static void page_begin(FILE *page, const char *title, const char *policy)
{
    fprintf(page,
            "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
            "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; "
            "%s; style-src 'unsafe-inline'\">\n"
            "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n",
            policy);
    html_write(page, "<title>%s</title>\n", title);
    fprintf(page, "<style>\n%s</style>\n</head>\n<body>\n<main>\n", html_style);
}

void html_page_begin(FILE *page, const char *title)
{
    page_begin(page, title, "img-src data:");
}

void html_album_begin(FILE *page, const char *title)
{
    page_begin(page, title, "img-src data: 'self'");
}

void html_followed_begin(FILE *page, const char *title, int number)
{
    page_begin(page, title, "img-src 'self'; script-src 'self' 'unsafe-inline'");
    fprintf(page,
            "<script>\n"
            "function news(number) { if (number !== %d) location.reload(); }\n"
            "setInterval(() => {\n"
            "  const script = document.createElement('script');\n"
            "  script.src = 'news.js?' + Date.now();\n"
            "  script.onload = script.onerror = () => script.remove();\n"
            "  document.head.append(script);\n"
            "}, 500);\n"
            "</script>\n",
            number);
}

void html_page_end(FILE *page)
{
    fputs("</main>\n</body>\n</html>\n", page);
}

void html_score_bar(FILE *page, int points, int max_points)
{
    double share = max_points > 0 ? (double)points / max_points : 0;
    const char *level = share >= 1 ? "full" : share >= 0.5 ? "some" : "few";
    fprintf(page,
            "<div class=\"bar %s\" role=\"img\" aria-label=\"%d of %d\">"
            "<div style=\"width: %.1f%%\"></div></div>\n",
            level, points, max_points, 100 * share);
}

void html_picture_uri(FILE *page, const char *uri)
{
    static const char signs[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/=";
    static const char *const kinds[] = {"data:image/png;base64,", "data:image/svg+xml;base64,"};
    for (size_t i = 0; uri != NULL && i < sizeof kinds / sizeof *kinds; i++) {
        const size_t n = strlen(kinds[i]);
        if (strncmp(uri, kinds[i], n) == 0 && strspn(uri + n, signs) == strlen(uri + n)) {
            fputs(uri, page);
        }
    }
}

void html_file_uri(FILE *page, const char *type, const void *bytes, size_t n_bytes)
{
    static const char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    const unsigned char *from = bytes;
    fprintf(page, "data:%s;base64,", type);
    for (size_t i = 0; i < n_bytes; i += 3) {
        unsigned second = i + 1 < n_bytes ? from[i + 1] : 0;
        unsigned third = i + 2 < n_bytes ? from[i + 2] : 0;
        unsigned group = (unsigned)from[i] << 16 | second << 8 | third;
        fputc(digits[group >> 18], page);
        fputc(digits[group >> 12 & 63], page);
        fputc(i + 1 < n_bytes ? digits[group >> 6 & 63] : '=', page);
        fputc(i + 2 < n_bytes ? digits[group & 63] : '=', page);
    }
}
