// right: work-items count rows from below; which of them draws a pixel is nobody's business
// task: own_pixel
    const int x = get_global_id(0);
    const int row = get_global_id(1);
    if (x >= width || row >= height) {
        return;
    }
    const int y = height - 1 - row;
