// Is an answer what was handed out? (See untouched.h.)
#include "untouched.h"

#include "holes.h"
#include "skeleton.h"
#include "source_words.h"

#include <stdlib.h>
#include <string.h>

// Do two texts say the same to a compiler? Comments and blanks say nothing.
static int are_same_words(const char *a, const char *b)
{
    SourceReader own = source_reader(a), handed_out = source_reader(b);
    SourceWord x, y;
    do {
        x = source_next(&own);
        y = source_next(&handed_out);
    } while (x.kind == y.kind && x.length == y.length && memcmp(x.start, y.start, x.length) == 0 &&
             x.kind != SOURCE_END);
    return x.kind == SOURCE_END && y.kind == SOURCE_END;
}

int answer_is_untouched(const Manifest *manifest, const Task *task, const char *answer)
{
    char *skeleton = skeleton_read(manifest, task->file);
    char *placeholder = skeleton != NULL ? hole_read(skeleton, task->id) : NULL;
    const int is_same = placeholder != NULL && are_same_words(answer, placeholder);
    free(placeholder);
    free(skeleton);
    return is_same;
}
