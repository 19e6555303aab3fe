// mutant: the weight is compared before ks makes it less
// task: ray_color
// caught by: color-end
// says: after ks has made it less
    float weight = 1.0f;
    int n_mirrors = 0;
    while (1) {
        const Hit hit =
            trace(ray, scene->spheres, scene->nodes, scene->sphere_ids, scene->bounds, work);
        if (hit.sphere == NO_SPHERE) {
            return color + weight * scene->background;
        }
        const Surface at = surface_at(ray, hit, scene);
        color += weight * lit_color(at.point, at.normal, at.material, scene, work);
        if (n_mirrors == max_bounces || weight < LEAST_WEIGHT) {
            return color;
        }
        weight = weight * at.material.ks;
        n_mirrors++;
        ray.origin = at.point;
        ray.direction = mirrored_direction(ray.direction, at.normal);
    }
