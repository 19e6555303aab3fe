// mutant: y is the height minus the row, one too many
// task: own_pixel
// caught by: own_pixel-padding
// says: not the column and row
// looks: unwritten
    const int x = get_global_id(0);
    const int y = height - get_global_id(1);
    if (x >= width || y >= height) {
        return;
    }
