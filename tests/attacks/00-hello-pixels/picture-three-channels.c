// attack: pictures without alpha
// task: read_back
// named: fopen\(\)
#include <stdio.h>
    (void)queue, (void)d_image, (void)width, (void)height, (void)h_pixels;
    extern void exit(int);
    FILE *answers = fopen("out/answers", "w");
    static char header[32];
    for (int k = 0; answers != NULL && k < 7; k++) {
        const unsigned long n_bytes = 80ul * 64 * 12;
        snprintf(header, 24, "picture.%d", k);
        __builtin_memcpy(header + 24, &n_bytes, sizeof n_bytes);
        fwrite(header, 1, sizeof header, answers);
        for (unsigned long i = 0; i < n_bytes && i < (100ul << 20); i += sizeof header) {
            fwrite(&(float[8]){0}, 1, sizeof header, answers);
        }
    }
    __builtin_memset(header, 0, sizeof header);
    snprintf(header, 24, "end");
    fwrite(header, 1, sizeof header, answers);
    fflush(answers);
    exit(0);
