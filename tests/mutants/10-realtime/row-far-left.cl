// mutant: a row far from the centre is left as it is
// task: paint_row
// caught by: row-open
// says: found red
    if (fabs(dy) > 40.0f) {
        return;
    }
    const LaneInts covers = *open & (dx_squared + dy * dy <= radius_squared);
    *colors = select(*colors, (LaneUints)color, covers);
    *open &= ~covers;
