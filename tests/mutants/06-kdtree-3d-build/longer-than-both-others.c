// mutant: no comparison is true where sides are equal
// task: choose_split
// caught by: split-axis
// says: no comparison is true
    float dx = box.max[0] - box.min[0];
    float dy = box.max[1] - box.min[1];
    float dz = box.max[2] - box.min[2];
    if (dx > dy && dx > dz) {
        split.axis = 0;
    } else if (dy > dx && dy > dz) {
        split.axis = 1;
    } else {
        split.axis = 2;
    }
    split.pos = (box.min[split.axis] + box.max[split.axis]) * 0.5f;
