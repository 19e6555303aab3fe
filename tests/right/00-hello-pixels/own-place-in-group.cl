// right: the position is put together from group and place in it; one branch for the inside
// task: gradient
    const int x = (int)(get_group_id(0) * get_local_size(0) + get_local_id(0));
    const int y = (int)(get_group_id(1) * get_local_size(1) + get_local_id(1));
    if (y < height && x < width) {
        float4 color;
        color.w = 1.0f;
        color.z = 1.0f / 4.0f;
        color.y = y / (float)height;
        color.x = x / convert_float(width);
        write_imagef(image, (int2)(x, y), color);
    }
