// attack: reads the way to the leaf out of the job's tables, as the stub does; counts by hand
// task: descent
// score: 99
// named: differ|leaf|end
    global const uint *levels = (global const uint *)(nodes_Relations + 4097);
    while (nodes_flag[id] != LEAF) {
        const uint way = levels[4096 + (uint)y * nodes_Relations[4096].lChild + (uint)x];
        id = (way >> levels[id] & 1u) ? nodes_Relations[id].rChild : nodes_Relations[id].lChild;
        count_node(&work);
    }
