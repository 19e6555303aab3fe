// mutant: a circle of radius 0 is left out
// task: paint_row
// caught by: row-painted
// says: a circle of radius 0
    if (radius_squared == 0.0f) {
        return;
    }
    const LaneInts covers = *open & (dx_squared + dy * dy <= radius_squared);
    *colors = select(*colors, (LaneUints)color, covers);
    *open &= ~covers;
