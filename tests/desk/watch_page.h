// The page beside the watch, build/watch/index.html: it loads itself anew when there is news.
#ifndef DESK_WATCH_PAGE_H
#define DESK_WATCH_PAGE_H

#include "look.h"

#include <jansson.h>

enum { NEWS_MOST_VERDICTS = 200 };

// What a verdict was, and when.
typedef struct Verdict {
    double seconds;  // since the watch began
    int score;
} Verdict;

// What the watch knows now. Texts are any text; all but the picture is owned.
typedef struct News {
    int number;        // of this news
    char *state;       // one line: what is done now, or what came of it
    char *said;        // the words of the compiler or the program; "" where there are none
    char *command;     // that follows the first wrong pixel, or NULL
    char *changes;     // gained and lost, a line each; ""
    const Look *look;  // the picture
    json_t *results;   // of the last verdict, or NULL
    Verdict verdicts[NEWS_MOST_VERDICTS];
    int n_verdicts;
} News;

// Release its texts and results.
void news_free(News *news);

// Write the page, and a script that tells an open one that there is news.
//   report  the path of the whole report from there
// Returns 0, or -1 after one message.
int watch_page_write(const News *news, const char *report);

#endif
