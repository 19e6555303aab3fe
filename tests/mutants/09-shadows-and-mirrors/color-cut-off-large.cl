// mutant: the cut-off is a tenth
// task: ray_color
// caught by: color-end
// says: end were above|expected
    float weight = 1.0f;
    for (int n_bounces = 0;; n_bounces++) {
        const Hit hit =
            trace(ray, scene->spheres, scene->nodes, scene->sphere_ids, scene->bounds, work);
        if (hit.sphere == NO_SPHERE) {
            return color + weight * scene->background;
        }
        const Surface at = surface_at(ray, hit, scene);
        color += weight * lit_color(at.point, at.normal, at.material, scene, work);
        weight *= at.material.ks;
        if (n_bounces == max_bounces || weight < 0.1f) {
            return color;
        }
        ray.origin = at.point;
        ray.direction = mirrored_direction(ray.direction, at.normal);
    }
