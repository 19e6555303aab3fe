// right: the middle as the borders' mean, in double
// task: split_box
    const double middle_x = 0.5 * ((double)box.minX + box.maxX);
    const double middle_y = 0.5 * ((double)box.minY + box.maxY);
    if (box.maxY - box.minY > box.maxX - box.minX) {
        left->maxY = (f32)middle_y;
        right->minY = (f32)middle_y;
    } else {
        left->maxX = (f32)middle_x;
        right->minX = (f32)middle_x;
    }
