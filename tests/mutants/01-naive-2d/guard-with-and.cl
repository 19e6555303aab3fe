// mutant: only work-items outside in both directions leave (&& instead of ||)
// task: own_pixel
// caught by: own_pixel-padding
// says: outside
    const int x = get_global_id(0);
    const int y = get_global_id(1);
    if (x >= width && y >= height) {
        return;
    }
