// attack: holds one marker line of another task
// task: getContainingChild
// score: 99
// named: second time
    return nodes_Relations[id].lChild;
    // END descent
