// mutant: signed distances, each for itself
// task: sphere_overlaps_box
// caught by: overlap-inside
// says: compared by itself
// looks: missing-in-cell
    return outside(sphere.x, box.min[0], box.max[0]) <= sphere.radius &&
           outside(sphere.y, box.min[1], box.max[1]) <= sphere.radius &&
           outside(sphere.z, box.min[2], box.max[2]) <= sphere.radius;
