// What a name that a system made says (see export.h).
#include "export.h"

#include <string.h>

int export_is_exact(const Export *export, const Found *found)
{
    return found->name.system == export->system &&
           course_system(found->name.system)->identity_writer == WRITER_SYSTEM;
}

int export_is_same_student(const Export *export, const Found *a, const Found *b)
{
    return export_is_exact(export, a) && export_is_exact(export, b) &&
           strcmp(a->name.name, b->name.name) == 0 && strcmp(a->name.number, b->name.number) == 0;
}

int export_attempt_end(const Export *export, int i)
{
    const Found *first = &export->found[i];
    int end = i + 1;
    while (first->is_loose && end < export->n_found && export->found[end].is_loose &&
           first->name.is_text == export->found[end].name.is_text &&
           export_is_same_student(export, first, &export->found[end]) &&
           strcmp(first->name.time, export->found[end].name.time) == 0) {
        end++;
    }
    return end;
}
