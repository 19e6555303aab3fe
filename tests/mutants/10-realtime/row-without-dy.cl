// mutant: the distance along y is forgotten
// task: paint_row
// caught by: row-open
// says: dy were 0
    (void)dy;
    const LaneInts covers = *open & (dx_squared <= radius_squared);
    *colors = select(*colors, (LaneUints)color, covers);
    *open &= ~covers;
