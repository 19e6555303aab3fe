// mutant: an epsilon widens the circle
// task: paint_row
// caught by: row-open
// says: without an epsilon
    const LaneInts covers = *open & (dx_squared + dy * dy <= radius_squared + 0.001f);
    *colors = select(*colors, (LaneUints)color, covers);
    *open &= ~covers;
