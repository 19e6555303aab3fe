// mutant: what was closed is open again
// task: paint_row
// caught by: row-painted
// says: open again
    const LaneInts covers = *open & (dx_squared + dy * dy <= radius_squared);
    *colors = select(*colors, (LaneUints)color, covers);
    *open = ~(dx_squared + dy * dy <= radius_squared);
