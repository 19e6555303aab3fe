// SHA-256 (FIPS 180-4), for names that nobody can make equal on purpose.
#ifndef CLASS_SHA256_H
#define CLASS_SHA256_H

#include <stddef.h>

enum { SHA256_BYTES = 32 };

void sha256(const void *bytes, size_t n_bytes, unsigned char digest[SHA256_BYTES]);

#endif
