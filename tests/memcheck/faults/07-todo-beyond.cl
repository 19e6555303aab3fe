// fault: keeps the far child behind the end of the stack
// lab: 07-kdtree-3d-trace
// task: next_child
// says: uses index 
    const uint side = near_side(node, origin, inverse);
    const uint near_child = side ? node.first + 1 : node.first;
    const uint far_child = side ? node.first : node.first + 1;
    float t_split;
    switch (children_on_ray(node, origin, inverse, t_min, t_max, &t_split)) {
    case ONLY_NEAR:
        return (TodoEntry){near_child, t_min, t_max};
    case ONLY_FAR:
        return (TodoEntry){far_child, t_min, t_max};
    default:
        todo->entries[TODO_SIZE + todo->n] = (TodoEntry){far_child, t_split, t_max};  // HERE
        todo->n++;
        return (TodoEntry){near_child, t_min, t_split};
    }
