// mutant: dy is not squared
// task: paint_row
// caught by: row-open
// says: dx_squared is squared
    const LaneInts covers = *open & (dx_squared + dy <= radius_squared);
    *colors = select(*colors, (LaneUints)color, covers);
    *open &= ~covers;
