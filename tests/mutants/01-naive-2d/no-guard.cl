// mutant: work-items outside the picture write too
// task: own_pixel
// caught by: own_pixel-padding
// says: outside
    (void)width, (void)height;
    const int x = get_global_id(0);
    const int y = get_global_id(1);
