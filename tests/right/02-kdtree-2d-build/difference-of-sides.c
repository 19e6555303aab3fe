// right: the sign of what height and width differ by
// task: split_box
    const f32 taller_by = (box.maxY - box.minY) - (box.maxX - box.minX);
    f32 *const end = taller_by > 0 ? &left->maxY : &left->maxX;
    f32 *const start = taller_by > 0 ? &right->minY : &right->minX;
    *end = *start = taller_by > 0 ? (box.minY + box.maxY) / 2 : (box.minX + box.maxX) / 2;
