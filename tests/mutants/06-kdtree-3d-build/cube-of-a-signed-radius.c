// mutant: the cube of a signed radius
// task: sphere_overlaps_box
// caught by: overlap-corner
// says: bounding cube
// looks: missing-in-cell
    return sphere.x >= box.min[0] - sphere.radius && sphere.x <= box.max[0] + sphere.radius &&
           sphere.y >= box.min[1] - sphere.radius && sphere.y <= box.max[1] + sphere.radius &&
           sphere.z >= box.min[2] - sphere.radius && sphere.z <= box.max[2] + sphere.radius &&
           outside(sphere.x, box.min[0], box.max[0]) < 1e30;
