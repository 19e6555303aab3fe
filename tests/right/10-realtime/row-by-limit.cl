// right: by what is left of the radius along x
// task: paint_row
    const float limit = radius_squared - dy * dy;
    const LaneInts paints = (dx_squared <= limit) & *open;
    *open ^= paints;
    *colors = select(*colors, (LaneUints)(color), paints);
