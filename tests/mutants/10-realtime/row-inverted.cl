// mutant: what is outside is painted
// task: paint_row
// caught by: row-open
// says: what the circle does not cover is painted
    const LaneInts covers = *open & (dx_squared + dy * dy > radius_squared);
    *colors = select(*colors, (LaneUints)color, covers);
    *open &= ~covers;
