// mutant: a sign: the square of dy is taken off
// task: paint_row
// caught by: row-open
// says: squares add up
    const LaneInts covers = *open & (dx_squared - dy * dy <= radius_squared);
    *colors = select(*colors, (LaneUints)color, covers);
    *open &= ~covers;
