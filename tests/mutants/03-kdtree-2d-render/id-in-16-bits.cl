// mutant: a node's id is kept in 16 bits
// task: descent
// caught by: descent-leaf
// says: too few bits
    for (ushort node = 0; nodes_flag[node] == INNER; id = node) {
        node = (ushort)getContainingChild(x, y, id, nodes_Relations, nodes_BBox, &work);
    }
