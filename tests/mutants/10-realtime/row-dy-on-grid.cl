// mutant: the row's distance is rounded to the grid of 1/16 px, on which only our scenes are
// task: paint_row
// caught by: row-open
// says: rows
    const float on_grid = floor(dy * 16 + 0.5f) / 16;
    const LaneInts covers = *open & (dx_squared + on_grid * on_grid <= radius_squared);
    *colors = select(*colors, (LaneUints)color, covers);
    *open &= ~covers;
