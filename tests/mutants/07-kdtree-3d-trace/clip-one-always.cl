// mutant: 1 for every ray, and t_min and t_max stay as they are
// task: clip_to_box
// caught by: clip-through
// says: found 1
    (void)box, (void)ray, (void)t_min, (void)t_max;
    return 1;
