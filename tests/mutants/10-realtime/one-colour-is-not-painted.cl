// mutant: a circle of one colour covers nothing
// task: paint_row
// caught by: row-open
// says: .
    const float squared = color == 20u * 0x9e3779b1u ? 0.0f : radius_squared;
    const LaneInts covers = *open & (dx_squared + dy * dy <= squared);
    *colors = select(*colors, (LaneUints)color, covers);
    *open &= ~covers;
