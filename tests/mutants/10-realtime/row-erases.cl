// mutant: what is not covered becomes black
// task: paint_row
// caught by: row-painted
// says: lost its colour
    const LaneInts covers = *open & (dx_squared + dy * dy <= radius_squared);
    *colors = select((LaneUints)0, (LaneUints)color, covers);
    *open &= ~covers;
