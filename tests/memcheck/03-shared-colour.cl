// fault: all work-items of a group keep their colour in one place
// lab: 03-kdtree-2d-render
// task: leaf_loop
// says: a race
    local float4 nearest;
    nearest.x = (float)x;
    color = nearest;  // HERE
