// right: both counts together first: no scene has half as many spheres as a u32 counts
// task: split_cost
    BBox3D lower = box, higher = box;
    lower.max[split.axis] = split.pos;
    higher.min[split.axis] = split.pos;
    const double a = surface_area(lower), b = surface_area(higher);
    const u32 both = n_lower + n_higher;
    return KD_COST_TRAVERSAL +
           KD_COST_TEST * (a * both + (b - a) * n_higher) / surface_area(box);
