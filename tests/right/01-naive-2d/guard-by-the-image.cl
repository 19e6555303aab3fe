// right: the image knows how large the picture is
// task: own_pixel
    const int x = get_global_id(0), y = get_global_id(1);
    const int2 size = get_image_dim(image);
    if (x >= size.x || y >= size.y) {
        return;
    }
