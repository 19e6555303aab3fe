// The CSV file of a bench (see measurements.h).
//
// Read next: tables.sql.
#include "measurements.h"

#include "path.h"

int measurements_open(Measurements *measurements, const char *folder, const char *bench)
{
    char path[PATH_MAX];
    path_make(path, "%s/%s.csv", folder, bench);
    if (output_file_open(&measurements->output, path) != 0) {
        return -1;
    }
    fprintf(measurements->output.file, "scene,what,quantity,round,value\n");
    return 0;
}

void measurements_add(Measurements *measurements, const char *scene, const char *what,
                      const char *quantity, double value)
{
    fprintf(measurements->output.file, "\"%s\",\"%s\",\"%s\",%d,%.9g\n", scene, what, quantity,
            measurements->round, value);
}

int measurements_close(Measurements *measurements, int result)
{
    if (result != 0) {
        output_file_discard(&measurements->output);
        return -1;
    }
    return output_file_commit(&measurements->output);
}
