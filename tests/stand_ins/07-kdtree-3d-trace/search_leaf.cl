    // By lot one of the leaf's spheres, as far away as its radius says, or none. No two have the
    // same radius.
    const uint column = (uint)fmin(fabs(4096.0f * ray.direction.x + 32.25f), 65535.0f);
    const uint row = (uint)fmin(fabs(4096.0f * ray.direction.y + 32.25f), 65535.0f);
    uint lot = node.first * 40503u + column * 30011u + row * 9973u;
    lot = ((lot ^ lot >> 15) * 2654435769u) >> 16;
    if (node.n_spheres > 0 && lot % 3u != 0u) {
        const uint id = sphere_ids[node.first + lot / 3u % node.n_spheres];
        hit->sphere = spheres[id].radius < hit->t ? id : hit->sphere;
        hit->t = fmin(hit->t, spheres[id].radius);
    }
#ifdef COUNT_WORK
    work->n_tests += node.n_spheres;
#endif
