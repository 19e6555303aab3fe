// mutant: a colour of zeros is taken for an open pixel
// task: paint_row
// caught by: row-painted
// says: a circle may be black
    const LaneInts covers = (*colors == 0) & (dx_squared + dy * dy <= radius_squared);
    *colors = select(*colors, (LaneUints)color, covers);
    *open &= ~covers;
