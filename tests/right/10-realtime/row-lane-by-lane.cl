// right: lane by lane, in arrays
// task: paint_row
    float distances[LANES];
    int opens[LANES];
    uint painted[LANES];
    JOIN(vstore, LANES)(dx_squared + dy * dy, 0, distances);
    JOIN(vstore, LANES)(*open, 0, opens);
    JOIN(vstore, LANES)(*colors, 0, painted);
    for (int lane = 0; lane < LANES; lane++) {
        if (opens[lane] && !(distances[lane] > radius_squared)) {
            opens[lane] = 0;
            painted[lane] = color;
        }
    }
    *open = JOIN(vload, LANES)(0, opens);
    *colors = JOIN(vload, LANES)(0, painted);
