// Writing the slides (see class_page.h). Read next: slides.html, the template.
#include "class_page.h"

#include "failures.h"
#include "html.h"
#include "manifest.h"
#include "output_file.h"
#include "path.h"
#include "template.h"

#include <jansson.h>
#include <limits.h>
#include <string.h>
#include <unistd.h>

TEMPLATE(slides_html, "tests/class/pages/slides.html");

enum { MOST_SLIDES = 5 };

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

static void uri_write(FILE *page, const void *picture)
{
    html_picture_uri(page, json_string_value(json_object_get(picture, "url")));
}

// One of the wrong pictures beside what it should be. Nothing where there is none.
static void pictures_add(json_t *slide, const Gradebook *gradebook, const Row *row)
{
    char path[PATH_MAX];
    json_error_t error;
    path_make(path, "%s/students/%s/pictures.json", gradebook->folder, row->entrant->slug);
    json_t *pictures = json_load_file(path, 0, &error);
    const int i = pair_find(pictures);
    if (i >= 0) {
        json_object_set_new(slide, "yours",
                            template_markup(uri_write, json_array_get(pictures, (size_t)i)));
        json_object_set_new(slide, "right",
                            template_markup(uri_write, json_array_get(pictures, (size_t)i + 1)));
    }
    json_decref(pictures);
}

// ---- Slides ------------------------------------------------------------------------------------

static json_t *slide_of(const Gradebook *gradebook, const Manifest *manifest,
                        const Failure *failure, int number)
{
    const Column *check = &gradebook->checks[failure->check];
    const Task *task = manifest_task(manifest, check->task);
    json_t *slide = json_pack(
        "{s:i, s:i, s:o, s:o, s:o}", "number", number, "n_rows", failure->n_rows, "task",
        template_line(task != NULL ? task->title : check->task), "mistake",
        template_line(failure->title), "cause", template_line(class_failure_words(failure, 0)));
    if (task != NULL) {
        json_object_set_new(slide, "hint", template_line(manifest_hint(task, check->id)));
    }
    if (failure->shown != NULL) {
        pictures_add(slide, gradebook, failure->shown);
    }
    return slide;
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
    json_t *slides = json_array();
    for (int i = 0; i < n_slides; i++) {
        json_array_append_new(slides, slide_of(gradebook, manifest, chosen[i], i + 1));
    }
    json_t *page = json_pack(
        "{s:o, s:o, s:i, s:b, s:o*, s:o}", "lab", template_line(gradebook->lab), "title",
        template_line(gradebook->title), "n_graded", gradebook->n_graded, "is_one", n_slides == 1,
        "n_slides", n_slides > 1 ? json_integer(n_slides) : NULL, "slides", slides);
    html_page_begin(output.file, gradebook->title);
    const int failed = template_write(output.file, slides_html, page);
    html_page_end(output.file);
    return template_commit(&output, failed);
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
