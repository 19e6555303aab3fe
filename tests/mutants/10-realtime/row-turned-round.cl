// mutant: covered pixels are turned round, closed ones open
// task: paint_row
// caught by: row-painted
// says: open again
    const LaneInts covered = dx_squared + dy * dy <= radius_squared;
    const LaneInts painted = *open & covered;
    *colors = select(*colors, (LaneUints)color, painted);
    *open ^= covered;
