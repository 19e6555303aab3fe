// right: the flag is kept in a variable and asked for INNER
// task: descent
    uchar flag = nodes_flag[0];
    while (flag == INNER) {
        id = getContainingChild(x, y, id, nodes_Relations, nodes_BBox, &work);
        flag = nodes_flag[id];
    }
