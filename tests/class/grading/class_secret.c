// Reading, drawing and using a class's secret (see class_secret.h).
#include "class_secret.h"

#include "complain.h"
#include "number.h"
#include "path.h"

#include <errno.h>
#include <fcntl.h>
#include <inttypes.h>
#include <nettle/hmac.h>
#include <stdio.h>
#include <string.h>
#include <sys/random.h>
#include <sys/stat.h>
#include <unistd.h>

#define NUMBER_MARK "SEED="

enum { SECRET_BYTES = CLASS_SECRET_DIGITS / 2, SEEDS_A_ROUND = 16 };

// ---- The file -----------------------------------------------------------------------------------

static int fault(const char *path, const char *reason)
{
    complain("grade-class: %s: %s", path, reason);
    return -1;
}

// Returns 0, or -1 after one message.
static int secret_draw(const char *path, ClassSecret *secret)
{
    unsigned char bytes[SECRET_BYTES];
    if (getrandom(bytes, sizeof bytes, 0) != sizeof bytes) {
        return fault(path, "the kernel gives no random bytes for it");
    }
    for (int i = 0; i < SECRET_BYTES; i++) {
        snprintf(secret->text + 2 * i, 3, "%02x", bytes[i]);
    }
    return 0;
}

// Nobody but the owner may read it at any time, so not by output_file.h. Returns 0, or -1 after one
// message.
static int secret_save(const char *path, const ClassSecret *secret)
{
    char partial[PATH_MAX];
    path_make(partial, "%s.new", path);
    unlink(partial);
    const int descriptor = open(partial, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
    FILE *file = descriptor >= 0 ? fdopen(descriptor, "w") : NULL;
    if (file == NULL) {
        return fault(partial, strerror(errno));
    }
    const int is_written =
        fprintf(file, "%s\n", secret->text) > 0 && fflush(file) == 0 && fsync(descriptor) == 0;
    if (fclose(file) != 0 || !is_written || rename(partial, path) != 0) {
        return fault(path, strerror(errno));
    }
    return 0;
}

static int is_drawn(const char *text)
{
    return strlen(text) == CLASS_SECRET_DIGITS &&
           strspn(text, "0123456789abcdef") == CLASS_SECRET_DIGITS;
}

static int is_number(const char *text)
{
    const size_t n_mark = strlen(NUMBER_MARK);
    uint64_t number;
    return strncmp(text, NUMBER_MARK, n_mark) == 0 &&
           number_read_unsigned(text + n_mark, 0, UINT64_MAX, &number) == 0;
}

// Returns 1, 0 where there is no such file, or -1 after one message: a secret that is cut short is
// never gone on with.
static int secret_read(const char *path, ClassSecret *secret)
{
    char line[sizeof secret->text + 1] = "";  // with its end
    struct stat status;
    // Neither another file of the owner's by a link, nor what never ends.
    const int descriptor = open(path, O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
    FILE *file = descriptor >= 0 ? fdopen(descriptor, "r") : NULL;
    if (file == NULL) {
        return errno == ENOENT ? 0 : fault(path, strerror(errno));
    }
    const int is_whole = fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode) &&
                         fgets(line, sizeof line, file) != NULL && strchr(line, '\n') != NULL &&
                         fgetc(file) == EOF;
    line[strcspn(line, "\n")] = '\0';
    const int is_secret = is_whole && (is_drawn(line) || is_number(line));
    // A copy of the folder may have opened it.
    const int is_closed = is_secret && fchmod(descriptor, 0600) == 0;
    fclose(file);
    if (!is_secret) {
        return fault(path, "no secret of a class; without this file a new one is drawn, and all is "
                           "graded again");
    }
    if (!is_closed) {
        return fault(path, "cannot be closed to others: it is not yours");
    }
    snprintf(secret->text, sizeof secret->text, "%s", line);
    return 1;
}

int class_secret_open(const char *folder, const uint64_t *number, ClassSecret *secret)
{
    char path[PATH_MAX];
    path_make(path, "%s/secret", folder);
    int result = 0;
    if (number != NULL) {
        snprintf(secret->text, sizeof secret->text, NUMBER_MARK "%" PRIu64, *number);
        result = secret_save(path, secret);
    } else if ((result = secret_read(path, secret)) == 0) {
        result = secret_draw(path, secret) != 0 ? -1 : secret_save(path, secret);
    }
    if (result >= 0 && is_number(secret->text)) {
        complain("grade-class: all seeds of this class follow from %s: who knows that can foresee "
                 "the hidden scenes; remove %s to have a secret drawn, and all graded again",
                 secret->text, path);
    }
    return result < 0 ? -1 : 0;
}

// ---- Seeds --------------------------------------------------------------------------------------

// 64 bits that nobody can tell without the secret, whatever others of them are known.
static uint64_t mac(const ClassSecret *secret, const char *text)
{
    struct hmac_sha256_ctx context;
    uint8_t digest[sizeof(uint64_t)];
    uint64_t bits = 0;
    hmac_sha256_set_key(&context, strlen(secret->text), (const uint8_t *)secret->text);
    hmac_sha256_update(&context, strlen(text), (const uint8_t *)text);
    hmac_sha256_digest(&context, sizeof digest, digest);
    for (size_t i = 0; i < sizeof digest; i++) {
        bits = bits << 8 | digest[i];
    }
    return bits;
}

uint64_t class_secret_seed(const ClassSecret *secret, const char *round, const char *slug)
{
    char text[256];
    snprintf(text, sizeof text, "which %s %s", round, slug);
    const unsigned which = (unsigned)(mac(secret, text) % SEEDS_A_ROUND);
    snprintf(text, sizeof text, "seed %s %u", round, which);
    return mac(secret, text);
}
