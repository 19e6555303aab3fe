// mutant: x counts rows and y columns
// task: own_pixel
// caught by: own_pixel-picture
// says: nobody wrote.* as where x and y are swapped
// never says: guard
// looks: unwritten
    const int x = get_global_id(1);
    const int y = get_global_id(0);
    if (x >= width || y >= height) {
        return;
    }
