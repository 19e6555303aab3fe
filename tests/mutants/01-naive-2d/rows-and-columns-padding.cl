// mutant: x counts rows and y columns, and the guard fits them
// task: own_pixel
// caught by: own_pixel-padding
// says: x and y are swapped
// never says: guard
// looks: unwritten
    const int x = get_global_id(1);
    const int y = get_global_id(0);
    if (y >= width || x >= height) {
        return;
    }
