// right: without select, by bits
// task: paint_row
    const LaneUints paints =
        JOIN(as_uint, LANES)(*open & islessequal(dx_squared + dy * dy, (Lanes)radius_squared));
    *colors = (*colors & ~paints) | (color & paints);
    *open = *open & ~JOIN(as_int, LANES)(paints);
