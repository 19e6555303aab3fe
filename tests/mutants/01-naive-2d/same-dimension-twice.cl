// mutant: a copied line: x and y both count columns, so only the diagonal is drawn
// task: own_pixel
// caught by: own_pixel-picture
// says: nobody wrote
// looks: unwritten
    const int x = get_global_id(0);
    const int y = get_global_id(0);
    if (x >= width || y >= height) {
        return;
    }
