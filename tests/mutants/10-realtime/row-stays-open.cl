// mutant: what is painted stays open
// task: paint_row
// caught by: row-open
// says: stays open
    const LaneInts covers = *open & (dx_squared + dy * dy <= radius_squared);
    *colors = select(*colors, (LaneUints)color, covers);
    *open &= -1;
