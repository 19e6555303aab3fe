// attack: a short line that makes a program of 1 GB
// task: split_box
// named: compiler did not finish|large|space|limit
// limit: 2
    static char giant[1 << 30] = {1};
    (void)box, giant[left->minX > 0] = 1;
