// From a seed to what is drawn from it, and no way back.
//
// A run sees what a job asks. SplitMix64 (common/random.h), by which that is drawn, can be
// reversed: who has one of its numbers whole has all the others. So no generator starts with the
// seed itself, and what is drawn for one purpose tells neither the seed nor what is drawn for
// another.
//
// The step is SipHash-2-4 (Aumasson, Bernstein 2012) of the purpose, with the seed as the key. It
// is written out because a handout does without nettle. Used at random.h, and by the judge for its
// jobs.
#ifndef PROBES_ONE_WAY_H
#define PROBES_ONE_WAY_H

#include <stdint.h>

typedef enum Purpose { PURPOSE_INPUTS = 1, PURPOSE_NONCE = 2 } Purpose;

static inline uint64_t sip_rotate(uint64_t word, int n)
{
    return word << n | word >> (64 - n);
}

static inline void sip_rounds(uint64_t v[4], int n)
{
    for (int i = 0; i < n; i++) {
        v[0] += v[1], v[2] += v[3];
        v[1] = sip_rotate(v[1], 13) ^ v[0], v[3] = sip_rotate(v[3], 16) ^ v[2];
        v[0] = sip_rotate(v[0], 32);
        v[2] += v[1], v[0] += v[3];
        v[1] = sip_rotate(v[1], 17) ^ v[2], v[3] = sip_rotate(v[3], 21) ^ v[0];
        v[2] = sip_rotate(v[2], 32);
    }
}

// SipHash-2-4 of a message of eight bytes.
static inline uint64_t siphash(uint64_t key, uint64_t rest_of_key, uint64_t message)
{
    const uint64_t words[2] = {message, (uint64_t)8 << 56};  // behind it stands its length
    uint64_t v[4] = {key ^ 0x736f6d6570736575u, rest_of_key ^ 0x646f72616e646f6du,
                     key ^ 0x6c7967656e657261u, rest_of_key ^ 0x7465646279746573u};
    for (int i = 0; i < 2; i++) {
        v[3] ^= words[i];
        sip_rounds(v, 2);
        v[0] ^= words[i];
    }
    v[2] ^= 0xff;
    sip_rounds(v, 4);
    return v[0] ^ v[1] ^ v[2] ^ v[3];
}

static inline uint64_t one_way(uint64_t seed, Purpose purpose)
{
    return siphash(seed, 0, purpose);
}

#endif
