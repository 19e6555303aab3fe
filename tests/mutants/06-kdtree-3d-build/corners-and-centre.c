// mutant: only the corners and the centre are asked
// task: sphere_overlaps_box
// caught by: overlap-inside
// says: side or over an edge
// looks: missing-in-cell
    const double r2 = (double)sphere.radius * sphere.radius;
    if (outside(sphere.x, box.min[0], box.max[0]) == 0 &&
        outside(sphere.y, box.min[1], box.max[1]) == 0 &&
        outside(sphere.z, box.min[2], box.max[2]) == 0) {
        return 1;
    }
    for (int corner = 0; corner < 8; corner++) {
        const double x = (double)sphere.x - (corner & 1 ? box.max[0] : box.min[0]);
        const double y = (double)sphere.y - (corner & 2 ? box.max[1] : box.min[1]);
        const double z = (double)sphere.z - (corner & 4 ? box.max[2] : box.min[2]);
        if (x * x + y * y + z * z <= r2) {
            return 1;
        }
    }
    return 0;
