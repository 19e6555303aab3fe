// mutant: the boundary does not belong to the circle
// task: paint_row
// caught by: row-open
// says: strict
// looks: strict-boundary
    const LaneInts covers = *open & (dx_squared + dy * dy < radius_squared);
    *colors = select(*colors, (LaneUints)color, covers);
    *open &= ~covers;
