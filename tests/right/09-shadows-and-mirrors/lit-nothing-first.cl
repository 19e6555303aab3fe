// right: what would add nothing sends no ray, for black surfaces, too
// task: lit_color
    int n_asked = 0;
    while (n_asked < scene->n_lights) {
        const int i = n_asked++;
        const float3 share = shade(point, normal, material, scene->lights + i, 1);
        if (share.x == 0.0f && share.y == 0.0f && share.z == 0.0f) {
            continue;
        }
        if (is_blocked(shadow_ray(point, scene->lights[i]), scene, work)) {
            continue;
        }
        color += share;
    }
