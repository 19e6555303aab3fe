// mutant: plus for minus in the way to the point
// task: camera_axes
// caught by: axes-forward
// says: minus .from., not plus
const Vec3 sum = {view.at.x + view.from.x, view.at.y + view.from.y, view.at.z + view.from.z};
*forward = vec3_normalized(sum);
*right = vec3_normalized(vec3_cross(*forward, view.up));
*up = vec3_cross(*right, *forward);
