// mutant: both children are visited, whether the ray meets them or not
// task: next_child
// caught by: child-one
// says: put on the stack
    const uint side = near_side(node, origin, inverse);
    todo_push(todo, node.first + 1 - side, t_min, t_max);
    return (TodoEntry){node.first + side, t_min, t_max};
