// What a class's seeds are made of, and only the class's folder knows: FOLDER/secret, mode 0600.
//
// It is 256 bits from the kernel, drawn once. A seed is 64 bits of an HMAC-SHA256 with it as the
// key. So reports, which show seeds, tell nothing of the seeds of other rounds, however many are
// gathered. Read next: class_keys.h, who has which seed.
#ifndef CLASS_CLASS_SECRET_H
#define CLASS_CLASS_SECRET_H

#include <stdint.h>

enum { CLASS_SECRET_DIGITS = 64 };

typedef struct ClassSecret {
    char text[CLASS_SECRET_DIGITS + 1];  // hexadecimal, or "SEED=7": see class_secret_open()
} ClassSecret;

// Read the secret of a class, or draw one if there is none.
//   number   NULL, or a number that takes the secret's place from now on ("SEED=7"). Two classes
//            with the same number have the same seeds, and who knows it can foresee them: for
//            tests, and said on stderr in every run
// Returns 0, or -1 after one message on stderr.
int class_secret_open(const char *folder, const uint64_t *number, ClassSecret *secret);

// The seed of an entry in a round: one of sixteen, so that the solution need not run for each
// entry. Which one it is, nobody can foresee either.
uint64_t class_secret_seed(const ClassSecret *secret, const char *round, const char *slug);

#endif
