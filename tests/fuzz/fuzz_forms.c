// Any bytes as an answer that is compared with others: its forms stand at lines that it has, none
// is empty, and a second reading gives the same.
#include "fuzz.h"

#include "forms.h"

static int count_lines(const char *text)
{
    int n = 1;
    for (; *text != '\0'; text++) {
        n += *text == '\n';
    }
    return n;
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t n_bytes)
{
    char *answer = calloc(1, n_bytes + 1);
    MUST_HOLD(answer != NULL);
    memcpy(answer, bytes, n_bytes);
    const int n_lines = count_lines(answer);
    Forms forms = forms_read(answer, NULL), again = forms_read(answer, NULL);
    MUST_HOLD(forms.n == again.n && forms.n <= FORMS_MAX);
    for (int i = 0; i < forms.n; i++) {
        const Form *form = &forms.all[i];
        MUST_HOLD(form->text[0] != '\0' && strcmp(form->text, again.all[i].text) == 0);
        MUST_HOLD(form->first_line >= 1 && form->first_line <= form->last_line &&
                  form->last_line <= n_lines);
    }
    forms_free(&forms);
    forms_free(&again);
    free(answer);
    return 0;
}
