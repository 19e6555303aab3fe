// mutant: rays that go down are left out
// task: direction_color
// caught by: color-picture
// says: nobody wrote
// looks: unwritten
    const Ray ray = primary_ray(x, y, width, height, camera);
    if (ray.direction.z < 0.0f) {
        return;
    }
    color = 0.5f * ray.direction + 0.5f;
