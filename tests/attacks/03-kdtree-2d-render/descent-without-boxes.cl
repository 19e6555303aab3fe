// attack: wrong (hands on other boxes), but the stub of getContainingChild never looks at them
// task: descent
// score: 99
// named: differ|end|leaf
    while (nodes_flag[id] != LEAF) {
        id = getContainingChild(x, y, id, nodes_Relations, nodes_BBox + 1, &work);
    }
