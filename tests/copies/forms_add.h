// Collecting the forms of an answer.
#ifndef COPIES_FORMS_ADD_H
#define COPIES_FORMS_ADD_H

#include "forms.h"

// Add one form, but no empty one. Takes the text over. The same form counts once against FORMS_MAX,
// and is kept at FORM_PLACES lines at most. Running out of memory ends the program.
enum { FORM_PLACES = 100 };
void forms_add(Forms *forms, FormKind kind, char *text, int first_line, int last_line);

// No form will be added: release what tells them apart.
void forms_complete(Forms *forms);

#endif
