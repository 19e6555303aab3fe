// mutant: leaves in the last column and row
// task: gradient
// caught by: gradient-picture
// says: last column
// looks: unwritten
    const int x = get_global_id(0);
    const int y = get_global_id(1);
    if (!(x < width - 1 && y < height - 1))
        return;
    write_imagef(image, (int2)(x, y), (float4)((float)x / width, (float)y / height, 0.25f, 1.0f));
