// mutant: pixels are counted from 1: column 0 and row 0 stay unwritten
// task: own_pixel
// caught by: own_pixel-picture
// says: nobody wrote
// looks: unwritten
    const int x = get_global_id(0) + 1;
    const int y = get_global_id(1) + 1;
    if (x >= width || y >= height) {
        return;
    }
