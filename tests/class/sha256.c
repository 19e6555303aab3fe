// SHA-256 as FIPS 180-4 writes it down (see sha256.h).
#include "sha256.h"

#include <stdint.h>
#include <string.h>

enum { BLOCK_BYTES = 64, N_ROUNDS = 64, LENGTH_BYTES = 8 };

// The fractional parts of the cube roots of the first 64 primes.
static const uint32_t constants[N_ROUNDS] = {
    0x428a2f98, 0x71374491, 0xb5c0fbcf, 0xe9b5dba5, 0x3956c25b, 0x59f111f1, 0x923f82a4, 0xab1c5ed5,
    0xd807aa98, 0x12835b01, 0x243185be, 0x550c7dc3, 0x72be5d74, 0x80deb1fe, 0x9bdc06a7, 0xc19bf174,
    0xe49b69c1, 0xefbe4786, 0x0fc19dc6, 0x240ca1cc, 0x2de92c6f, 0x4a7484aa, 0x5cb0a9dc, 0x76f988da,
    0x983e5152, 0xa831c66d, 0xb00327c8, 0xbf597fc7, 0xc6e00bf3, 0xd5a79147, 0x06ca6351, 0x14292967,
    0x27b70a85, 0x2e1b2138, 0x4d2c6dfc, 0x53380d13, 0x650a7354, 0x766a0abb, 0x81c2c92e, 0x92722c85,
    0xa2bfe8a1, 0xa81a664b, 0xc24b8b70, 0xc76c51a3, 0xd192e819, 0xd6990624, 0xf40e3585, 0x106aa070,
    0x19a4c116, 0x1e376c08, 0x2748774c, 0x34b0bcb5, 0x391c0cb3, 0x4ed8aa4a, 0x5b9cca4f, 0x682e6ff3,
    0x748f82ee, 0x78a5636f, 0x84c87814, 0x8cc70208, 0x90befffa, 0xa4506ceb, 0xbef9a3f7, 0xc67178f2,
};

static uint32_t rotated(uint32_t word, int n)
{
    return word >> n | word << (32 - n);
}

static void schedule_fill(const unsigned char block[BLOCK_BYTES], uint32_t w[N_ROUNDS])
{
    for (int t = 0; t < 16; t++) {
        w[t] = (uint32_t)block[4 * t] << 24 | (uint32_t)block[4 * t + 1] << 16 |
               (uint32_t)block[4 * t + 2] << 8 | block[4 * t + 3];
    }
    for (int t = 16; t < N_ROUNDS; t++) {
        const uint32_t a = w[t - 15];
        const uint32_t b = w[t - 2];
        const uint32_t sigma0 = rotated(a, 7) ^ rotated(a, 18) ^ a >> 3;
        const uint32_t sigma1 = rotated(b, 17) ^ rotated(b, 19) ^ b >> 10;
        w[t] = sigma1 + w[t - 7] + sigma0 + w[t - 16];
    }
}

static void block_take(uint32_t state[8], const unsigned char block[BLOCK_BYTES])
{
    uint32_t w[N_ROUNDS], s[8];
    schedule_fill(block, w);
    memcpy(s, state, sizeof s);
    for (int t = 0; t < N_ROUNDS; t++) {
        const uint32_t sum0 = rotated(s[0], 2) ^ rotated(s[0], 13) ^ rotated(s[0], 22);
        const uint32_t sum1 = rotated(s[4], 6) ^ rotated(s[4], 11) ^ rotated(s[4], 25);
        const uint32_t choice = (s[4] & s[5]) ^ (~s[4] & s[6]);
        const uint32_t majority = (s[0] & s[1]) ^ (s[0] & s[2]) ^ (s[1] & s[2]);
        const uint32_t first = s[7] + sum1 + choice + constants[t] + w[t];
        memmove(s + 1, s, 7 * sizeof *s);
        s[4] += first;
        s[0] = first + sum0 + majority;
    }
    for (int i = 0; i < 8; i++) {
        state[i] += s[i];
    }
}

// What is left of the message, a one bit, zeros, and the message's length in bits.
static void end_take(uint32_t state[8], const unsigned char *rest, size_t n_rest, size_t n_bytes)
{
    unsigned char blocks[2 * BLOCK_BYTES] = {0};
    const size_t n_blocks = n_rest + 1 + LENGTH_BYTES > BLOCK_BYTES ? 2 : 1;
    memcpy(blocks, rest, n_rest);
    blocks[n_rest] = 0x80;
    for (size_t i = 0; i < LENGTH_BYTES; i++) {
        blocks[n_blocks * BLOCK_BYTES - 1 - i] = (unsigned char)((uint64_t)n_bytes * 8 >> 8 * i);
    }
    for (size_t i = 0; i < n_blocks; i++) {
        block_take(state, blocks + i * BLOCK_BYTES);
    }
}

void sha256(const void *bytes, size_t n_bytes, unsigned char digest[SHA256_BYTES])
{
    // The fractional parts of the square roots of the first eight primes.
    uint32_t state[8] = {0x6a09e667, 0xbb67ae85, 0x3c6ef372, 0xa54ff53a,
                         0x510e527f, 0x9b05688c, 0x1f83d9ab, 0x5be0cd19};
    const unsigned char *at = bytes;
    size_t n_left = n_bytes;
    for (; n_left >= BLOCK_BYTES; n_left -= BLOCK_BYTES, at += BLOCK_BYTES) {
        block_take(state, at);
    }
    end_take(state, at, n_left, n_bytes);
    for (int i = 0; i < SHA256_BYTES; i++) {
        digest[i] = (unsigned char)(state[i / 4] >> (24 - 8 * (i % 4)));
    }
}
