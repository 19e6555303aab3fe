    const int n = (x + 2 * y + 3 * width + 5 * height + (int)(64.0f * camera.fov)) % 31;
    const Vec3 axis = n % 3 == 0 ? camera.right : n % 3 == 1 ? camera.up : camera.forward;
    const float side = n % 2 == 0 ? 1.0f : -1.0f;
    ray.direction.x = side * axis.x;
    ray.direction.y = side * axis.y;
    ray.direction.z = side * axis.z;
    ray.origin = ray.direction;
    ray.t_min = 1.0f;
    ray.t_max = 2.0f;
