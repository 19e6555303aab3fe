// mutant: a pixel stays open where the circle only touches the row
// task: paint_row
// caught by: row-open
// says: only touches
    const LaneInts covers = *open & (dx_squared + dy * dy <= radius_squared);
    *colors = select(*colors, (LaneUints)color, covers);
    if (dy * dy != radius_squared) {
        *open &= ~covers;
    }
