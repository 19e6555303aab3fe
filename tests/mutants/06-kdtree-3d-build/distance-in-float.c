// mutant: distances are rounded to float before they are squared
// task: sphere_overlaps_box
// caught by: overlap-touching
// says: distances rounded
    const f32 x = (f32)outside(sphere.x, box.min[0], box.max[0]),
              y = (f32)outside(sphere.y, box.min[1], box.max[1]);
    const f32 z = (f32)outside(sphere.z, box.min[2], box.max[2]);
    return (double)x * x + (double)y * y + (double)z * z <= (double)sphere.radius * sphere.radius;
