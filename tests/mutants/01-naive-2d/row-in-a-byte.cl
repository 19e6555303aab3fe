// mutant: 8 bits are to hold the row
// task: own_pixel
// caught by: own_pixel-picture
// says: nobody wrote
// looks: unwritten
    const int x = get_global_id(0);
    const uchar y = get_global_id(1);
    if (x >= width || y >= height) {
        return;
    }
