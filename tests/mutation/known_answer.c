// Reading known answers (see known_answer.h).
#include "known_answer.h"

#include "complain.h"
#include "edits.h"
#include "holes.h"
#include "path.h"
#include "text_file.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

// The first word of each answer, and the name of the file.
static const char *const KINDS[N_KNOWN_FILES] = {"wrong", "right"};

// A file that is read, and how far.
typedef struct Reading {
    KnownAnswers *answers;
    const Manifest *manifest;
    int kind;
    const char *path;
    int line;           // the one that is read, from 1
    const Task *task;   // under whose heading it is, or NULL
    char *solution;     // the solution's answer to it. Owned
    const char *check;  // under whose heading it is, or NULL
    KnownAnswer *open;  // the answer that it belongs to, or NULL
    // Of that answer the edits, NULL before their first line; and where they begin and end.
    const char *edits;
    char *edits_end;
    int edits_line;
    int n_misfits;  // answers whose edits do not fit: all are named
} Reading;

// One message about a line. Returns -1.
__attribute__((format(printf, 3, 4))) static int refuse(const Reading *reading, int line,
                                                        const char *format, ...)
{
    char said[512];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(said, sizeof said, format, arguments);
    va_end(arguments);
    complain("%s:%d: %s", reading->path, line, said);
    return -1;
}

// ---- One answer ---------------------------------------------------------------------------------

// The answer has all its lines: make its text. One that does not fit is named, and noted.
// Returns 0, or -1 after one message, as all below.
static int close_answer(Reading *reading)
{
    KnownAnswer *answer = reading->open;
    char *why = NULL;
    int line = 0;
    reading->open = NULL;
    if (answer == NULL) {
        return 0;
    }
    if (!answer->is_right && answer->says == NULL) {
        return refuse(reading, answer->line, "%s: no line \"says: ...\"", answer->name);
    }
    if (reading->edits != NULL) {
        *reading->edits_end = '\0';
    }
    answer->text =
        edits_apply(reading->solution, reading->edits ? reading->edits : "", &why, &line);
    line += reading->edits != NULL ? reading->edits_line : answer->line;
    if (answer->text == NULL) {
        refuse(reading, line, "%s, %s: %s", answer->task->id, answer->name, why);
        reading->n_misfits++;
    }
    free(why);
    return 0;
}

// "wrong half-pixel: the corner for the middle". Its name is behind the first word.
static int open_answer(Reading *reading, char *name)
{
    KnownAnswers *answers = reading->answers;
    char *colon = strstr(name, ": ");
    if (reading->task == NULL || (reading->kind == 0 && reading->check == NULL)) {
        return refuse(reading, reading->line, "an answer before the heading of its task or check");
    }
    if (colon == NULL || colon[2] == '\0') {
        return refuse(reading, reading->line, "found \"%s %s\", expected \"%s name: what it does\"",
                      KINDS[reading->kind], name, KINDS[reading->kind]);
    }
    *colon = '\0';
    if (known_answers_find(answers, name) != NULL) {
        return refuse(reading, reading->line, "a second answer called %s", name);
    }
    if (answers->n == KNOWN_MAX) {
        return refuse(reading, reading->line, "more than %d answers", KNOWN_MAX);
    }
    reading->open = &answers->all[answers->n++];
    *reading->open = (KnownAnswer){
        .path = reading->path,
        .line = reading->line,
        .name = name,
        .task = reading->task,
        .is_right = reading->kind != 0,
        .check = reading->check,
    };
    reading->edits = NULL;
    return 0;
}

// The kinds of mistake behind "looks: ".
static int read_mistakes(Reading *reading, char *ids)
{
    KnownAnswer *answer = reading->open;
    char *rest = NULL;
    for (char *id = strtok_r(ids, " ", &rest); id != NULL; id = strtok_r(NULL, " ", &rest)) {
        const Mistake mistake = mistake_find(id);
        if (mistake == MISTAKE_NONE) {
            return refuse(reading, reading->line, "no kind of mistake is called \"%s\"", id);
        }
        answer->first_mistake = answer->mistakes == 0 ? mistake : answer->first_mistake;
        answer->mistakes |= 1u << mistake;
    }
    return 0;
}

// ---- Lines --------------------------------------------------------------------------------------

// What a line says behind its first words, or NULL where it begins otherwise.
static char *behind(char *line, const char *words)
{
    const size_t length = strlen(words);
    return strncmp(line, words, length) == 0 ? line + length : NULL;
}

// The solution's answer to a task: what is in its hole, without the placeholder. NULL after one
// message.
static char *solution_read(const Reading *reading, const Task *task)
{
    char path[PATH_MAX];
    path_make(path, "solutions/%s/%s", reading->manifest->lab, task->file);
    char *hole = hole_load(path, task->id);
    char *to = hole;
    if (hole == NULL) {
        refuse(reading, reading->line, "%s: no hole %s", path, task->id);
        return NULL;
    }
    for (const char *line = hole; *line != '\0';) {
        const size_t length = strcspn(line, "\n") + 1;
        if (strncmp(line + strspn(line, " "), "//>", 3) != 0) {
            memmove(to, line, length);
            to += length;
        }
        line += length;
    }
    *to = '\0';
    return hole;
}

static int begin_task(Reading *reading, const char *id)
{
    reading->task = manifest_task(reading->manifest, id);
    reading->check = NULL;
    free(reading->solution);
    reading->solution = NULL;
    if (reading->task == NULL) {
        return refuse(reading, reading->line, "no task of the lab is called %s", id);
    }
    reading->solution = solution_read(reading, reading->task);
    return reading->solution != NULL ? 0 : -1;
}

static int begin_check(Reading *reading, const char *id)
{
    reading->check = NULL;
    for (int i = 0; reading->task != NULL && i < reading->task->n_checks; i++) {
        if (strcmp(reading->task->checks[i].id, id) == 0) {
            reading->check = reading->task->checks[i].id;
        }
    }
    return reading->check != NULL
               ? 0
               : refuse(reading, reading->line, "no check of task %s is called %s",
                        reading->task ? reading->task->id : "(none)", id);
}

// A line between an answer's first one and its edits.
static int read_expected(Reading *reading, char *line)
{
    KnownAnswer *answer = reading->open;
    char *text;
    if (answer == NULL || reading->edits != NULL) {
        return refuse(reading, reading->line,
                      "found \"%.80s\", expected a heading, \"%s ...\", "
                      "an edit or a line with \"#\"",
                      line, KINDS[reading->kind]);
    }
    if ((text = behind(line, "says: ")) != NULL && answer->says == NULL) {
        answer->says = text;
    } else if ((text = behind(line, "never says: ")) != NULL && answer->never == NULL) {
        answer->never = text;
    } else if ((text = behind(line, "looks: ")) != NULL && answer->mistakes == 0) {
        return read_mistakes(reading, text);
    } else if (behind(line, "alone: passes, ") != NULL) {
        answer->passes_alone = 1;
    } else {
        return refuse(reading, reading->line,
                      "found \"%.80s\", expected \"says: ...\", \"never "
                      "says: ...\", \"looks: ...\" or \"alone: passes, "
                      "...\", each once",
                      line);
    }
    return 0;
}

// A line of an edit, with its end.
static int read_edit(Reading *reading, char *line, char *end)
{
    if (reading->open == NULL) {
        return refuse(reading, reading->line, "an edit that belongs to no answer");
    }
    if (reading->edits == NULL) {
        reading->edits = line;
        reading->edits_line = reading->line;
    }
    reading->edits_end = end;
    return 0;
}

// Any other line that is not empty.
static int read_line(Reading *reading, char *line)
{
    char *task = behind(line, "=== task "),
         *check = reading->kind == 0 ? behind(line, "== check ") : NULL;
    char *answer = behind(line, KINDS[reading->kind]);
    answer = answer != NULL && *answer == ' ' ? answer + 1 : NULL;
    if (task == NULL && check == NULL && answer == NULL && *line != '#') {
        return read_expected(reading, line);
    }
    const int result = close_answer(reading);
    return result != 0      ? result
           : task != NULL   ? begin_task(reading, task)
           : check != NULL  ? begin_check(reading, check)
           : answer != NULL ? open_answer(reading, answer)
                            : 0;
}

// ---- Files --------------------------------------------------------------------------------------

static int read_text(Reading *reading, char *text)
{
    int result = 0;
    for (char *line = text; result == 0 && *line != '\0';) {
        char *end = line + strcspn(line, "\n");
        char *next = *end == '\0' ? end : end + 1;
        reading->line++;
        if (strchr("+- ", *line) != NULL) {
            result = read_edit(reading, line, end);
        } else if (line < end) {  // an empty one is between two edits, or says nothing
            *end = '\0';
            result = read_line(reading, line);
        }
        line = next;
    }
    result = result == 0 ? close_answer(reading) : -1;
    return reading->n_misfits == 0 ? result : -1;
}

int known_answers_read(KnownAnswers *answers, const Manifest *manifest)
{
    int result = 0;
    answers->n = 0;
    for (int kind = 0; kind < N_KNOWN_FILES; kind++) {
        char *path = answers->paths[kind];
        path_make(path, KNOWN_FOLDER "/%s/%s.diff", manifest->lab, KINDS[kind]);
        const int is_there = access(path, F_OK) == 0;
        answers->texts[kind] = is_there ? text_file_read(path) : NULL;
        if (answers->texts[kind] == NULL) {
            result |= is_there ? -1 : 0;
        } else {
            Reading reading = {answers, manifest, kind, path, .line = 0};
            result |= read_text(&reading, answers->texts[kind]);
            free(reading.solution);
        }
    }
    return result;
}

void known_answers_free(KnownAnswers *answers)
{
    for (int i = 0; i < answers->n; i++) {
        free(answers->all[i].text);
        free(answers->all[i].why);
    }
    for (int kind = 0; kind < N_KNOWN_FILES; kind++) {
        free(answers->texts[kind]);
        answers->texts[kind] = NULL;
    }
    answers->n = 0;
}

KnownAnswer *known_answers_find(KnownAnswers *answers, const char *name)
{
    for (int i = 0; i < answers->n; i++) {
        if (strcmp(answers->all[i].name, name) == 0) {
            return &answers->all[i];
        }
    }
    return NULL;
}

void known_answers_keep(KnownAnswers *answers, const char *word)
{
    int n = 0;
    for (int i = 0; i < answers->n; i++) {
        if (strstr(answers->all[i].name, word) != NULL) {
            answers->all[n++] = answers->all[i];
        } else {
            free(answers->all[i].text);
        }
    }
    answers->n = n;
}

// ---- How a mistake was named --------------------------------------------------------------------

int answer_is_named(const KnownAnswer *answer)
{
    return answer->mistakes != 0 && (answer->named >> answer->first_mistake & 1);
}

unsigned answer_misnamed(const KnownAnswer *answer)
{
    return answer->named & ~answer->mistakes;
}
