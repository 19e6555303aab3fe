// mutant: the work-item's place in its work-group is taken for its place in the picture
// task: own_pixel
// caught by: own_pixel-picture
// says: nobody wrote
// looks: unwritten
    const int x = get_local_id(0);
    const int y = get_local_id(1);
    if (x >= width || y >= height) {
        return;
    }
