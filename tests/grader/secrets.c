// Looking whether secrets are closed (see secrets.h): tried as a user who has no rights, not
// computed from modes, as lists of rights, mounts and the folders above all have their say.
// Read next: session.c, which asks before anything of a submission is run.
#include "secrets.h"

#include "path.h"
#include "sandbox_user.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

// Told by an exit status, a bit for each.
enum { MAX_SECRETS = 6, EXIT_NOT_ASKED = 1 << MAX_SECRETS };

// Folders that must not be reached.
typedef struct Secrets {
    char paths[MAX_SECRETS][PATH_MAX];
    int n;
} Secrets;

// Who asks has become another user: can it list a folder, pass it or read a file?
static int can_reach(const char *path)
{
    const int descriptor = open(path, O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC);
    if (descriptor >= 0) {
        close(descriptor);
        return 1;
    }
    return chdir(path) == 0;
}

// Which of the secrets can be reached by a user without rights: a bit for each. -1 when nobody can
// be asked.
static int reachable_find(const Secrets *secrets)
{
    int status;
    const pid_t asker = fork();
    if (asker == 0) {
        const uid_t user = user_own();
        int bits = 0;
        if (user_become(user) != 0 || getuid() != user) {
            _exit(EXIT_NOT_ASKED);
        }
        for (int i = 0; i < secrets->n; i++) {
            bits |= can_reach(secrets->paths[i]) << i;
        }
        _exit(bits);
    }
    while (asker > 0 && waitpid(asker, &status, 0) < 0 && errno == EINTR)
        ;
    return asker > 0 && WIFEXITED(status) && WEXITSTATUS(status) != EXIT_NOT_ASKED
               ? WEXITSTATUS(status)
               : -1;
}

// Add what is there.
static void secret_add(Secrets *secrets, const char *path)
{
    secrets->n += realpath(path, secrets->paths[secrets->n]) != NULL;
}

// Add the folder that something lies in: what is of others lies beside it. Where everybody may
// write there, it is no folder of the instructor's, and only the thing itself is added.
static void neighbourhood_add(Secrets *secrets, const char *path)
{
    char own[PATH_MAX], above[PATH_MAX];
    struct stat status;
    // It may not be there yet; what it is to lie in is.
    const int is_there = realpath(path, own) != NULL;
    path_make(above, "%s", is_there ? own : path);
    char *slash = strrchr(above, '/');
    if (slash == NULL) {
        strcpy(above, ".");
    } else {
        slash[slash == above] = '\0';
    }
    const int is_shared =
        stat(above, &status) != 0 || (status.st_mode & S_IWOTH) != 0 || strcmp(above, "/") == 0;
    secret_add(secrets, is_shared ? path : above);
}

// What to close for it: the course's top folder for all that lies in that.
static const char *closing_of(const char *secret, const char *top)
{
    const size_t length = strlen(top);
    return strncmp(secret, top, length) == 0 && secret[length] == '/' ? top : secret;
}

static void complain(const Secrets *secrets, int bits, const char *top)
{
    fputs("sandbox: a user of its own for each run hides no file that every user of this machine "
          "may read, and\n  these can be:\n",
          stderr);
    for (int i = 0; i < secrets->n; i++) {
        if ((bits >> i & 1) != 0) {
            fprintf(stderr, "      %s\n", secrets->paths[i]);
        }
    }
    fputs("  Close them, and grade again:\n", stderr);
    int is_top_named = 0;
    for (int i = 0; i < secrets->n; i++) {
        const char *closing = closing_of(secrets->paths[i], top);
        if ((bits >> i & 1) != 0 && !(closing == top && is_top_named)) {
            fprintf(stderr, "      chmod o-rwx '%s'\n", closing);
            is_top_named |= closing == top;
        }
    }
}

int secrets_check(const Settings *settings)
{
    char solution[sizeof "solutions/" + sizeof settings->lab], top[PATH_MAX];
    Secrets secrets = {0};
    snprintf(solution, sizeof solution, "solutions/%s", settings->lab);
    secret_add(&secrets, solution);
    secret_add(&secrets, "tests");
    secret_add(&secrets, settings->build);
    neighbourhood_add(&secrets, settings->submission);
    neighbourhood_add(&secrets, settings->output);
    if (settings->kept_answers != NULL) {
        neighbourhood_add(&secrets, settings->kept_answers);
    }
    const int bits = reachable_find(&secrets);
    if (bits < 0 || realpath(".", top) == NULL) {
        fprintf(stderr, "sandbox: cannot see what every user may read: %s\n", strerror(errno));
        return -1;
    }
    if (bits != 0) {
        complain(&secrets, bits, top);
    }
    return bits == 0 ? 0 : -1;
}
