// Any bytes as the answers of a hostile probe: whatever is found in them lies in them.
#include "fuzz.h"

#include "sections.h"

enum { MAX_BYTES = 4096 };

// A section, if there is one of that name: aligned, within the file, and what sections_find() gives.
static void check_section(const Sections *sections, const char *name)
{
    size_t n_bytes = SIZE_MAX;
    const unsigned char *bytes = sections_find_any(sections, name, &n_bytes);
    if (bytes == NULL) {
        return;
    }
    const size_t start = (size_t)(bytes - sections->bytes);
    MUST_HOLD(start <= sections->n_bytes && n_bytes <= sections->n_bytes - start);
    MUST_HOLD((uintptr_t)bytes % SECTION_ALIGNMENT == 0);
    MUST_HOLD(sections_find(sections, name, n_bytes) == bytes);
    MUST_HOLD(sections_find(sections, name, n_bytes + 1) == NULL);
    MUST_HOLD(strncmp((const char *)bytes - 32, name, SECTION_NAME_BYTES) == 0);
    // The sanitizer sees whether all of it may be read.
    unsigned sum = 0;
    for (size_t i = 0; i < n_bytes; i++) {
        sum += bytes[i];
    }
    MUST_HOLD(sum <= 255u * n_bytes);
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t n_bytes)
{
    InputFile input;
    input_file_make(bytes, n_bytes, &input);
    Sections sections;
    const int result = sections_load(input.path, MAX_BYTES, &sections);
    MUST_HOLD(result == 0 || result == -1);
    MUST_HOLD(result == -1 || n_bytes == sections.n_bytes);
    MUST_HOLD(sections.n_bytes <= n_bytes && sections.n_bytes <= MAX_BYTES);
    check_section(&sections, "a");
    check_section(&sections, "");
    // Names that the file itself gives, at every place where a header may stand.
    for (size_t start = 0; start + 32 <= sections.n_bytes; start += SECTION_ALIGNMENT) {
        char name[SECTION_NAME_BYTES + 1] = "";
        memcpy(name, sections.bytes + start, SECTION_NAME_BYTES);
        check_section(&sections, name);
    }
    sections_free(&sections);
    input_file_remove(&input);
    return 0;
}
