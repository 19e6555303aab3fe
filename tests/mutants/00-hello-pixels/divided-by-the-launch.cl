// mutant: divides by the size of the launch
// task: gradient
// caught by: gradient-picture
// says: get_global_size
    size_t x = get_global_id(0), y = get_global_id(1);
    if (x >= (size_t)width || y >= (size_t)height)
        return;
    write_imagef(image, (int2)((int)x, (int)y),
                 (float4)((float)x / (float)get_global_size(0), (float)y / (float)get_global_size(1), 0.25f, 1.0f));
