// mutant: 1 for -1
// task: paint_row
// caught by: row-open
// says: neither -1 nor 0
    const LaneInts covers = *open & (dx_squared + dy * dy <= radius_squared);
    *colors = select(*colors, (LaneUints)color, covers);
    *open = select((LaneInts)0, (LaneInts)1, *open & ~covers);
