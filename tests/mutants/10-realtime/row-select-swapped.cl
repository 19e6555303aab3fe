// mutant: select has its first two the other way round
// task: paint_row
// caught by: row-open
// says: stand in each other.s place
    const LaneInts covers = *open & (dx_squared + dy * dy <= radius_squared);
    *colors = select((LaneUints)color, *colors, covers);
    *open &= ~covers;
