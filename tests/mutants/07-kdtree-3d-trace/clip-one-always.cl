// mutant: 1 for every ray, and t_near and t_far stay as they are
// task: clip_to_box
// caught by: clip-through
// says: found 1
    (void)box, (void)ray, (void)t_near, (void)t_far;
    return 1;
