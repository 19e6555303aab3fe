// mutant: a farther circle paints over a nearer one
// task: paint_row
// caught by: row-painted
// says: painted again
    const LaneInts covers = (dx_squared + dy * dy <= radius_squared);
    *colors = select(*colors, (LaneUints)color, covers);
    *open &= ~covers;
