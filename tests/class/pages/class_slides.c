// Writing the slides (see class_slides.h).
#include "class_slides.h"

#include "class_page.h"
#include "complain.h"
#include "failures.h"
#include "html.h"
#include "manifest.h"
#include "output_file.h"
#include "path.h"

#include <jansson.h>
#include <limits.h>
#include <string.h>
#include <unistd.h>

enum { MOST_SLIDES = 5 };

static const char slide_style[] =
    "<style>\n"
    "html { scroll-snap-type: y mandatory; }\n"
    "main { max-width: none; padding: 0; }\n"
    ".slide { min-height: 100vh; scroll-snap-align: start; padding: 6vh 6vw; display: flex;\n"
    "  flex-direction: column; justify-content: center; gap: 3vh; font-size: clamp(1rem, 2.1vw, "
    "2rem); }\n"
    ".slide h1, .slide h2 { font-size: clamp(1.5rem, 3.6vw, 3.5rem); line-height: 1.15; }\n"
    ".slide .lab, .slide .soft { font-size: 0.7em; }\n"
    ".slide .cause { font-weight: 600; }\n"
    ".slide .cause::first-letter { text-transform: uppercase; }\n"
    ".slide .hint { border: 0; border-radius: 0.5rem; padding: 1rem 1.25rem; }\n"
    ".slide .row { display: grid; grid-template-columns: minmax(0, 3fr) minmax(0, 2fr); gap: 4vw;\n"
    "  align-items: center; }\n"
    ".slide .row > div { display: grid; gap: 3vh; }\n"
    ".slide figure { margin-bottom: 2vh; }\n"
    ".slide figure img { width: 100%; max-height: 34vh; object-fit: contain; object-position: "
    "left;\n"
    "  image-rendering: pixelated; }\n"
    ".slide figcaption { font-size: 0.6em; }\n"
    "@media (max-width: 50rem) { .slide .row { grid-template-columns: 1fr; } }\n"
    "@media print { @page { size: 297mm 167mm; margin: 0; } .slide { break-after: page; } }\n"
    "</style>\n";

// ---- Pictures ----------------------------------------------------------------------------------

// Does a text end so?
static int ends_in(const char *text, const char *end)
{
    const size_t n_text = strlen(text), n_end = strlen(end);
    return n_text > n_end && strcmp(text + n_text - n_end, end) == 0;
}

// Of a student's wrong pictures the largest and, behind it, what it should be: two numbers of the
// list follow each other. Returns the first one's, or -1.
static int pair_find(const json_t *pictures)
{
    int found = -1;
    size_t n_most = 0;
    for (size_t i = 0; i + 1 < json_array_size(pictures); i++) {
        const char *own = json_string_value(json_object_get(json_array_get(pictures, i), "label"));
        const json_t *next = json_array_get(pictures, i + 1);
        const char *right = json_string_value(json_object_get(next, "label"));
        const size_t n_bytes = json_string_length(json_object_get(next, "url"));
        if (own != NULL && right != NULL && ends_in(own, "(yours)") &&
            ends_in(right, "(as it should be)") && n_bytes > n_most) {
            found = (int)i;
            n_most = n_bytes;
        }
    }
    return found;
}

static void picture_write(FILE *page, const json_t *picture, const char *caption)
{
    fprintf(page, "<figure><figcaption>%s</figcaption><img alt=\"\" src=\"", caption);
    html_picture_uri(page, json_string_value(json_object_get(picture, "url")));
    fputs("\"></figure>\n", page);
}

// One of the wrong pictures beside what it should be. Nothing where there is none.
static void pictures_write(FILE *page, const Gradebook *gradebook, const Row *row)
{
    char path[PATH_MAX];
    json_error_t error;
    path_make(path, "%s/students/%s/pictures.json", gradebook->folder, row->entrant->slug);
    json_t *pictures = json_load_file(path, 0, &error);
    const int i = pair_find(pictures);
    if (i >= 0) {
        fputs("<div>\n", page);
        picture_write(page, json_array_get(pictures, (size_t)i), "one of those handed in");
        picture_write(page, json_array_get(pictures, (size_t)i + 1), "as it should be");
        fputs("</div>\n", page);
    }
    json_decref(pictures);
}

// ---- Slides ------------------------------------------------------------------------------------

static void title_write(FILE *page, const Gradebook *gradebook, int n_slides)
{
    fputs("<section class=\"slide\"><p class=\"lab\">", page);
    html_line(page, gradebook->lab);
    fputs("</p><h1>", page);
    html_line(page, gradebook->title);
    fprintf(page, "</h1><p>%d submissions. ", gradebook->n_graded);
    if (n_slides == 0) {
        fputs("Nothing went wrong.</p></section>\n", page);
    } else if (n_slides == 1) {
        fputs("The most frequent mistake, and what helps.</p></section>\n", page);
    } else {
        fprintf(page, "The %d most frequent mistakes, and what helps.</p></section>\n", n_slides);
    }
}

static void slide_write(FILE *page, const Gradebook *gradebook, const Manifest *manifest,
                        const Failure *failure, int number)
{
    const Column *check = &gradebook->checks[failure->check];
    const Task *task = manifest_task(manifest, check->task);
    fprintf(page, "<section class=\"slide\" id=\"slide-%d\"><p class=\"soft\">%d of %d, in ",
            number, failure->n_rows, gradebook->n_graded);
    html_line(page, task != NULL ? task->title : check->task);
    fputs("</p><h2>", page);
    html_line(page, failure->title);
    fputs("</h2>\n<div class=\"row\"><div>\n<p class=\"cause\">", page);
    html_line(page, class_failure_words(failure, 0));
    fputs("</p>\n", page);
    if (task != NULL) {
        fputs("<p class=\"hint\"><b>Hint</b> ", page);
        html_line(page, manifest_hint(task, check->id));
        fputs("</p>\n", page);
    }
    fputs("</div>\n", page);
    if (failure->shown != NULL) {
        pictures_write(page, gradebook, failure->shown);
    }
    fputs("</div></section>\n", page);
}

// The mistakes that get a slide: those of the judge that most made, at most five, and none of a
// hidden check. Returns how many.
static int slides_choose(const Failures *failures, const Failure *chosen[MOST_SLIDES])
{
    int n = 0;
    for (int i = 0; i < failures->n_failures && n < MOST_SLIDES; i++) {
        const Failure *failure = &failures->failures[i];
        if (failure->check >= 0 && !failure->rows[0]->is_hidden[failure->check]) {
            chosen[n++] = &failures->failures[i];
        }
    }
    return n;
}

static int slides_write(const Gradebook *gradebook, const Manifest *manifest,
                        const Failures *failures, const char *path)
{
    const Failure *chosen[MOST_SLIDES];
    OutputFile output;
    if (output_file_open(&output, path) != 0) {
        return -1;
    }
    const int n_slides = slides_choose(failures, chosen);
    html_page_begin(output.file, gradebook->title);
    fputs(slide_style, output.file);
    title_write(output.file, gradebook, n_slides);
    for (int i = 0; i < n_slides; i++) {
        slide_write(output.file, gradebook, manifest, chosen[i], i + 1);
    }
    html_page_end(output.file);
    return output_file_commit(&output);
}

int gradebook_slides(const Gradebook *gradebook, const char *path)
{
    Manifest manifest;
    Failures failures;
    if (gradebook->lab == NULL) {
        unlink(path);  // nothing was graded
        return 0;
    }
    if (gradebook_manifest(gradebook, gradebook->lab, &manifest) != 0) {
        return -1;
    }
    int result = failures_find(gradebook, &failures);
    if (result == 0) {
        result = slides_write(gradebook, &manifest, &failures, path);
        failures_free(&failures);
    }
    manifest_free(&manifest);
    return result;
}
