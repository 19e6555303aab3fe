    // A bit of n_spheres, which no inner node needs: by the eye's whole number and the ray's way.
    const uint eye = (uint)fmin(fabs(origin), 7.0f);
    return node.n_spheres >> (inverse > 0.0f ? eye + 8u : eye) & 1u;
