// mutant: one lane decides for all
// task: paint_row
// caught by: row-open
// says: one pixel decided
    const LaneInts covers = (LaneInts)(any(*open & (dx_squared + dy * dy <= radius_squared)) ? -1 : 0) & *open;
    *colors = select(*colors, (LaneUints)color, covers);
    *open &= ~covers;
