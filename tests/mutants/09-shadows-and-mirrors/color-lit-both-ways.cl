// mutant: every surface asks for its light twice, and one answer is kept
// task: ray_color
// caught by: color-rays
// says: asked twice
    float weight = 1.0f;
    for (int n_bounces = 0;; n_bounces++) {
        const Hit hit =
            trace(ray, scene->spheres, scene->nodes, scene->sphere_ids, scene->bounds, work);
        if (hit.sphere == NO_SPHERE) {
            return color + weight * scene->background;
        }
        const Surface at = surface_at(ray, hit, scene);
        const float3 own = lit_color(at.point, at.normal, at.material, scene, work);
        const float3 mirrored = lit_color(at.point, at.normal, at.material, scene, work);
        color += n_bounces == 0 ? own : weight * mirrored;
        weight *= at.material.ks;
        if (n_bounces == max_bounces || weight < LEAST_WEIGHT) {
            return color;
        }
        ray.origin = at.point;
        ray.direction = mirrored_direction(ray.direction, at.normal);
    }
