// mutant: the wrong pixels are closed
// task: paint_row
// caught by: row-open
// says: wrong pixels stay open
    const LaneInts covers = *open & (dx_squared + dy * dy <= radius_squared);
    *colors = select(*colors, (LaneUints)color, covers);
    *open &= covers;
