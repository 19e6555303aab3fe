// mutant: the guard asks for the column and forgets the row
// task: own_pixel
// caught by: own_pixel-padding
// says: outside
    (void)height;
    const int x = get_global_id(0);
    const int y = get_global_id(1);
    if (x >= width) {
        return;
    }
