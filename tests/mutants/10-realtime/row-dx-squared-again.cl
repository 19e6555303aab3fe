// mutant: dx_squared is squared once more
// task: paint_row
// caught by: row-open
// says: dx is squared twice
    const LaneInts covers = *open & (dx_squared * dx_squared + dy * dy <= radius_squared);
    *colors = select(*colors, (LaneUints)color, covers);
    *open &= ~covers;
