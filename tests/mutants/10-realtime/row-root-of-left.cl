// mutant: a distance is compared with a square
// task: paint_row
// caught by: row-open
// says: not with a distance
    const LaneInts covers = *open & (sqrt(dx_squared + dy * dy) <= radius_squared);
    *colors = select(*colors, (LaneUints)color, covers);
    *open &= ~covers;
