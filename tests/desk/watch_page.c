// Writing the watch's page (see watch_page.h).
//
// It has the looks of the report (html_style.h). The one script in it compares the number of the
// news with that in news.js twice a second; no other text is part of a script. Read next: watch.c.
#include "watch_page.h"

#include "html.h"
#include "output_file.h"
#include "path.h"
#include "results.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

void news_free(News *news)
{
    free(news->state);
    free(news->said);
    free(news->command);
    free(news->changes);
    json_decref(news->results);
}

static void head_write(FILE *page, const Manifest *lab, const News *news)
{
    html_write(page,
               "<header>\n<div class=\"head\"><div><p class=\"lab\">%s</p>\n<h1>%s</h1></div>\n",
               lab->lab, lab->title);
    if (news->results != NULL) {
        html_write(page, "<p class=\"score number\">%d <small>of %d points</small></p>",
                   number_of(news->results, "score"), number_of(news->results, "max_score"));
    }
    fputs("</div>\n", page);
    if (news->results != NULL) {
        html_score_bar(page, number_of(news->results, "score"),
                       number_of(news->results, "max_score"));
    }
    html_write(page, "<p class=\"soft\">%s</p>\n", news->state);
    html_message(page, news->changes);
    fputs("</header>\n", page);
}

static void said_write(FILE *page, const News *news)
{
    if (news->said[0] != '\0') {
        fputs("<section class=\"card stages\"><div class=\"check failed\">"
              "<span class=\"mark\">&#10007;</span>",
              page);
        html_message(page, news->said);
        fputs("</div></section>\n", page);
    }
}

static void picture_write(FILE *page, const char *name, const char *words, int number)
{
    fprintf(page,
            "<figure><figcaption>%s</figcaption><img src=\"%s.png?%d\" alt=\"%s\"></figure>\n",
            words, name, number, words);
}

// What a program that does not compile, crashes or has no end drew before it did so is still shown,
// and in any case what it shall draw.
static void pictures_write(FILE *page, const News *news)
{
    const Look *look = news->look;
    const int n_different = look->difference.n_different;
    html_write(page,
               "<section class=\"card\"><div class=\"title\"><b>The open scene</b></div>\n"
               "<p class=\"soft\">drawn with %s",
               look_options(look));
    if (look->is_compared && n_different > 0) {
        fprintf(page, "; %d pixels differ, the first is (%d, %d)", n_different,
                look->difference.first_x, look->difference.first_y);
    } else if (look->is_compared) {
        fputs("; no pixel differs", page);
    }
    fputs("</p><div class=\"trio\">\n", page);
    if (look->has_picture) {
        picture_write(page, "picture", look->is_older ? "Yours, before this change" : "Yours",
                      news->number);
    } else {
        fputs("<figure><figcaption>Yours</figcaption><p class=\"missing\">no picture yet</p>"
              "</figure>\n",
              page);
    }
    if (look->figure.pixels != NULL) {
        picture_write(page, "expected", "As it should be", news->number);
    }
    if (look->is_compared) {
        picture_write(page, "difference", "Difference: black where equal", news->number);
    }
    fputs("</div>\n", page);
    if (news->command != NULL) {
        html_write(page, "<p class=\"hint\"><b>See why</b> <code>%s</code></p>\n", news->command);
    }
    fputs("</section>\n", page);
}

// What ended the whole: a crash, an endless loop.
static void stages_write(FILE *page, const json_t *results)
{
    size_t i;
    json_t *stage;
    json_array_foreach(json_object_get(results, "stages"), i, stage)
    {
        if (strcmp(text_of(stage, "status"), "failed") == 0) {
            html_write(page,
                       "<div class=\"check failed\"><span class=\"mark\">&#10007;</span><div>"
                       "<span class=\"name\">%s</span></div><span></span>\n",
                       text_of(stage, "title"));
            html_message(page, text_of(stage, "message"));
            fputs("</div>\n", page);
        }
    }
}

// A line a task: a failed one is marked as in the terminal, and the first has its message.
static void verdict_write(FILE *page, const News *news, const char *report)
{
    const json_t *first = NULL;
    size_t i;
    json_t *task;
    if (news->results == NULL) {
        return;
    }
    fputs("<section class=\"card stages\">\n", page);
    stages_write(page, news->results);
    json_array_foreach(json_object_get(news->results, "tasks"), i, task)
    {
        const int points = number_of(task, "points"), most = number_of(task, "max_points");
        const json_t *fault = results_task_fault(news->results, text_of(task, "id"));
        fputs(points == most  ? "<div class=\"check passed\"><span class=\"mark\">&#10003;</span>"
              : fault != NULL ? "<div class=\"check failed\"><span class=\"mark\">&#10007;</span>"
                              : "<div class=\"check not-run\"><span class=\"mark\">&ndash;</span>",
              page);
        html_write(page,
                   "<div><span class=\"name\">%s</span> <code class=\"id\">%s</code></div>"
                   "<span class=\"number\">%d / %d</span>\n",
                   text_of(task, "title"), text_of(task, "id"), points, most);
        if (first == NULL && fault != NULL) {
            html_message(page, text_of(fault, "message"));
            first = fault;
        }
        fputs("</div>\n", page);
    }
    html_write(page, "<p class=\"hint\"><a href=\"%s\">The whole report</a></p></section>\n",
               report);
}

// Points over time, as steps from the left edge to the right.
static void history_write(FILE *page, const News *news)
{
    enum { WIDTH = 700, HEIGHT = 120, FOOT = 20 };
    if (news->n_verdicts < 2) {
        return;
    }
    const double most = news->verdicts[news->n_verdicts - 1].seconds;
    fprintf(page,
            "<section class=\"card\"><div class=\"title\"><b>Points over time</b></div>\n"
            "<div class=\"histogram\"><svg viewBox=\"-40 -12 %d %d\" role=\"img\" "
            "aria-label=\"points over time\"><path fill=\"none\" stroke=\"currentColor\" "
            "stroke-width=\"2\" d=\"",
            WIDTH + 60, HEIGHT + FOOT + 16);
    for (int i = 0; i < news->n_verdicts; i++) {
        const double x = most > 0 ? WIDTH * news->verdicts[i].seconds / most : 0;
        const double y = HEIGHT * (1 - news->verdicts[i].score / 100.0);
        fprintf(page, i == 0 ? "M%.1f %.1f" : "H%.1fV%.1f", x, y);
    }
    fprintf(page,
            "\"/><text class=\"soft\" x=\"-22\" y=\"4\">100</text>"
            "<text class=\"soft\" x=\"-16\" y=\"%d\">0</text>"
            "<text class=\"soft\" x=\"20\" y=\"%d\">0 min</text>"
            "<text class=\"soft\" x=\"%d\" y=\"%d\">%.0f min</text></svg></div></section>\n",
            HEIGHT, HEIGHT + FOOT, WIDTH - 16, HEIGHT + FOOT, most / 60);
}

int watch_page_write(const News *news, const char *report)
{
    const char *folder = news->look->folder;
    const Manifest *lab = news->look->desk->lab;
    char path[PATH_MAX];
    OutputFile page, script;
    path_make(path, "%s/index.html", folder);
    if (output_file_open(&page, path) != 0) {
        return -1;
    }
    html_followed_begin(page.file, lab->lab, news->number);
    head_write(page.file, lab, news);
    said_write(page.file, news);
    pictures_write(page.file, news);
    verdict_write(page.file, news, report);
    history_write(page.file, news);
    html_page_end(page.file);
    if (output_file_commit(&page) != 0) {
        return -1;
    }
    path_make(path, "%s/news.js", folder);
    if (output_file_open(&script, path) != 0) {
        return -1;
    }
    fprintf(script.file, "news(%d);\n", news->number);
    return output_file_commit(&script);
}
