// mutant: what is covered is closed before it is painted
// task: paint_row
// caught by: row-open
// says: not painted before
    const LaneInts covered = dx_squared + dy * dy <= radius_squared;
    *open &= ~covered;
    const LaneInts painted = *open & covered;
    *colors = select(*colors, (LaneUints)color, painted);
