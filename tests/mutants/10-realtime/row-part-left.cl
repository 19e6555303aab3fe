// mutant: a row that is painted in part is left as it is
// task: paint_row
// caught by: row-painted
// says: painted in part
    if (!all(*open)) {
        return;
    }
    const LaneInts covered = dx_squared + dy * dy <= radius_squared;
    const LaneInts painted = *open & covered;
    *colors = select(*colors, (LaneUints)color, painted);
    *open &= ~painted;
