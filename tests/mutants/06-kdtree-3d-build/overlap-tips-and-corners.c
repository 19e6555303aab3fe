// mutant: asks the cell's corners, the centre and the sphere's six tips
// task: sphere_overlaps_box
// caught by: overlap-inside
// says: found
// looks: missing-in-cell
    const double c[3] = {sphere.x, sphere.y, sphere.z}, r = fabs((double)sphere.radius);
    for (int tip = 0; tip < 7; tip++) {
        int inside = 1;
        for (int axis = 0; axis < 3; axis++) {
            const double p = c[axis] + (tip / 2 == axis ? (tip % 2 ? r : -r) : 0);
            inside &= p >= box.min[axis] && p <= box.max[axis];
        }
        if (inside) {
            return 1;
        }
    }
    for (int corner = 0; corner < 8; corner++) {
        double d2 = 0;
        for (int axis = 0; axis < 3; axis++) {
            const double p = corner >> axis & 1 ? box.max[axis] : box.min[axis];
            d2 += (p - c[axis]) * (p - c[axis]);
        }
        if (d2 <= r * r) {
            return 1;
        }
    }
    (void)outside;
    return 0;
