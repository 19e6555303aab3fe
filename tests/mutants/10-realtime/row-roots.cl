// mutant: roots are compared, which float rounds
// task: paint_row
// caught by: row-open
// says: compare the squares
    const LaneInts covered = sqrt(dx_squared + dy * dy) <= sqrt(radius_squared);
    const LaneInts painted = *open & covered;
    *colors = select(*colors, (LaneUints)color, painted);
    *open &= ~painted;
