// mutant: the guard compares x with the height and y with the width
// task: own_pixel
// caught by: own_pixel-picture
// says: nobody wrote.* or width and height
// looks: unwritten
    const int x = get_global_id(0);
    const int y = get_global_id(1);
    if (x >= height || y >= width) {
        return;
    }
