// mutant: the corner, from a middle in whole numbers
// task: pixel_on_display
// caught by: display-middle
// says: whole numbers
// looks: shifted-half
    const float right = (x - width / 2) * fov / width;
    const float up = (height / 2 - y) * fov / width;
    return (float3)(right, up, 1.0f);
