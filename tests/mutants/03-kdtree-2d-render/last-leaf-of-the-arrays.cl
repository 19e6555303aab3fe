// mutant: the last leaf in the arrays that holds the pixel; steps are counted by hand
// task: descent
// caught by: descent-leaf
// says: looked for in the arrays
    uint end = 1;
    for (uint node = 0; node < end; node++) {
        const BBox2D box = nodes_BBox[node];
        const int is_held = x >= box.minX && x < box.maxX && y >= box.minY && y < box.maxY;
        if (nodes_flag[node] != LEAF) {
            end = max(end, nodes_Relations[node].rChild + 1);
            if (is_held) {
                count_node(&work);
            }
        } else if (is_held) {
            id = node;
        }
    }
