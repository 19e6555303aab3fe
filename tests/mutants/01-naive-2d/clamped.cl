// mutant: work-items outside the picture draw its border once more
// task: own_pixel
// caught by: own_pixel-padding
// says: once more
    const int x = min((int)get_global_id(0), width - 1);
    const int y = min((int)get_global_id(1), height - 1);
