// mutant: the radius is squared twice
// task: paint_row
// caught by: row-open
// says: squared twice
    const LaneInts covers = *open & (dx_squared + dy * dy <= radius_squared * radius_squared);
    *colors = select(*colors, (LaneUints)color, covers);
    *open &= ~covers;
