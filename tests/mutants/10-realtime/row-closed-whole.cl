// mutant: the whole row is closed at once
// task: paint_row
// caught by: row-open
// says: whole row is closed
    const LaneInts covers = *open & (dx_squared + dy * dy <= radius_squared);
    *colors = select(*colors, (LaneUints)color, covers);
    *open = any(covers) ? (LaneInts)0 : *open;
