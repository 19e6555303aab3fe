// mutant: the textbook's form
// task: intersect_sphere
// caught by: sphere-far-small
// says: digits
    return intersect_textbook(sphere, ray);
