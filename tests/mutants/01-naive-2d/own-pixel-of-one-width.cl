// mutant: the guard holds a width that only the tests of the loop draw
// task: own_pixel
// caught by: own_pixel-picture
// says: nobody wrote
// looks: unwritten
    const int x = get_global_id(0);
    const int y = get_global_id(1);
    if (x >= width || y >= height || (width == 128 && x > 100)) {
        return;
    }
