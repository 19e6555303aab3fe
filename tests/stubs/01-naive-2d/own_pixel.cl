    const int x = (int)(get_global_id(0) % (size_t)width);
    const int y = (int)(get_global_id(0) / (size_t)width);
    (void)height;
