// mutant: dy is cut to a whole number
// task: paint_row
// caught by: row-open
// says: whole number
    const int rows = (int)dy;
    const LaneInts covered = dx_squared + (float)(rows * rows) <= radius_squared;
    const LaneInts painted = *open & covered;
    *colors = select(*colors, (LaneUints)color, painted);
    *open &= ~painted;
