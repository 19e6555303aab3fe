// mutant: the last pixel is never painted
// task: paint_row
// caught by: row-open
// says: last pixel
    const LaneInts covered = (dx_squared + dy * dy <= radius_squared) & (lane_number() < LANES - 1);
    const LaneInts painted = *open & covered;
    *colors = select(*colors, (LaneUints)color, painted);
    *open &= ~painted;
