// Any bytes as the archive that a student handed in: unpacked and staged like one.
//
// libarchive itself is the system's and not varied towards new branches; a mutator that mends the
// sums of tar's headers lets most inputs pass its first look.
#include "fuzz.h"

#include "file_kind.h"
#include "stage.h"
#include "unpack.h"

#include <archive.h>
#include <fcntl.h>

enum { TAR_BLOCK = 512, TAR_SUM = 148, TAR_SUM_BYTES = 8 };

static const Manifest manifest = {.lab = "03-x", .files = {"a.cl", "b.c"}, .n_files = 2};

// Unpack into an open folder. Returns as unpack() does.
static int bytes_unpack(const uint8_t *bytes, size_t n_bytes, int folder, char *message)
{
    struct archive *reader = unpack_reader_new();
    MUST_HOLD(reader != NULL);
    int status = UNPACK_NO_ARCHIVE;
    message[0] = '\0';
    if (archive_read_open_memory(reader, bytes, n_bytes) == ARCHIVE_OK) {
        status = unpack(reader, &manifest, folder, message);
    }
    archive_read_free(reader);
    return status;
}

// What was unpacked is a folder like any other: staged, or refused with lines fit for a terminal.
static void check_staging(const InputFile *input)
{
    char *said;
    char staged[96];
    snprintf(staged, sizeof staged, "%s/lab", input->folder);
    const int status =
        stage_submission(&manifest, &(StageSource){.folder = input->out}, 1, staged, &said);
    MUST_HOLD(status == 0 || status == 1 || status == STAGE_NOTHING);
    MUST_HOLD(status == 0 || said != NULL);
    MUST_HOLD(said == NULL || is_showable(said));
    free(said);
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t n_bytes)
{
    InputFile input;
    char message[UNPACK_MESSAGE_BYTES];
    input_file_make(bytes, 0, &input);
    const int folder = open(input.out, O_RDONLY | O_DIRECTORY);
    const int status = bytes_unpack(bytes, n_bytes, folder, message);
    close(folder);
    MUST_HOLD(status == 0 || status == 1 || status == UNPACK_NO_ARCHIVE);
    MUST_HOLD(status != 1 || message[0] != '\0');
    MUST_HOLD(status != UNPACK_NO_ARCHIVE || message[0] == '\0');
    MUST_HOLD(file_kind(bytes, n_bytes).name[0] == 'a');
    check_staging(&input);
    input_file_remove(&input);
    return 0;
}

// ---- Mutations ------------------------------------------------------------------------------

// libFuzzer's own; not there when the corpus is only run through.
__attribute__((weak)) size_t LLVMFuzzerMutate(uint8_t *bytes, size_t n_bytes, size_t most);
size_t LLVMFuzzerCustomMutator(uint8_t *bytes, size_t n_bytes, size_t most, unsigned seed);

// Where a tar header seems to stand, write the sum that it needs.
size_t LLVMFuzzerCustomMutator(uint8_t *bytes, size_t n_bytes, size_t most, unsigned seed)
{
    (void)seed;
    n_bytes = LLVMFuzzerMutate(bytes, n_bytes, most);
    for (size_t start = 0; start + TAR_BLOCK <= n_bytes; start += TAR_BLOCK) {
        uint8_t *header = bytes + start;
        unsigned sum = 0;
        if (memcmp(header + 257, "ustar", 5) != 0) {
            continue;
        }
        memset(header + TAR_SUM, ' ', TAR_SUM_BYTES);
        for (int i = 0; i < TAR_BLOCK; i++) {
            sum += header[i];
        }
        char digits[TAR_SUM_BYTES];
        snprintf(digits, sizeof digits, "%06o", sum);
        memcpy(header + TAR_SUM, digits, sizeof digits - 1);
    }
    return n_bytes;
}
