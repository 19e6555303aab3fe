// attack: never reads the image: copies the pattern that is expected out of the job
// task: read_back
// named: open\(\)
    extern int open(const char *, int, ...);
    extern long read(int, void *, unsigned long), lseek(int, long, int);
    static int k;
    struct { char name[24]; long n; } h = {"", 0};
    const int job = open("job/job", 0);
    while (read(job, &h, 32) == 32 && (h.name[0] != 's' || h.name[8] != 'p' || h.name[6] != '0' + k)) {
        lseek(job, (h.n + 15) / 16 * 16, 1);
    }
    k += read(job, h_pixels, (unsigned long)h.n) > 0;
    (void)queue, (void)d_image, (void)width, (void)height;
