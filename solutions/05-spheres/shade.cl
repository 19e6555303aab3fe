// Lab 05: the colour of a point on a sphere, in the light of the scene. Lab 07 uses it, too.
//
// Flow: scene -> buffers -> KERNEL -> image. Called by render_spheres.cl.
#include "ray.h"
#include "shading.h"
#include "sphere.h"

// The unit vector at right angles to the sphere at one of its points, on the side the ray comes
// from.
//   point       on the sphere, as float rounds it, scene units
//   direction   the ray's
float3 surface_normal(Sphere sphere, float3 point, float3 direction)
{
    // TASK surface_normal: the unit vector from the centre to the point. If it points away from
    // where the ray came from, as it does if the eye is inside the sphere, turn it round.
    //> (void)sphere, (void)point, (void)direction;
    //> return (float3)(0.0f);
    const float3 normal = normalize(point - (float3)(sphere.x, sphere.y, sphere.z));
    return dot(normal, direction) > 0.0f ? -normal : normal;
    // END surface_normal
}

// Lambert's law: a surface scatters a light in proportion to the cosine of the angle between its
// normal and the way to the light, and nothing if the light is behind it. No shadows yet.
//   point, normal      scene units; unit vector
//   lights[n_lights]   the scene's; their brightness does not fall with distance
// Returns red, green and blue: 0 without light, above 1 in much light. Source: Lambert,
// Photometria, 1760; the lecture's slide "KD-Tree Raytracing" only says that a hit is shaded.
float3 shade(float3 point, float3 normal, Material material, global const Light *lights,
             int n_lights)
{
    float3 color = (float3)(0.0f);
    // TASK shade: for each light add kd x cosine x the material's colour x the light's colour.
    //> (void)point, (void)normal, (void)material, (void)lights, (void)n_lights;
    for (int i = 0; i < n_lights; i++) {
        const Light light = lights[i];
        const float3 to_light = normalize(to_float3(light.position) - point);
        const float cosine = fmax(0.0f, dot(normal, to_light));
        color += material.kd * cosine * to_float3(material.color) * to_float3(light.color);
    }
    // END shade
    return color;
}

// The colour of a ray: of the surface it hits, or the background.
//   hit                  the nearest hit, if there is one
//   spheres, materials   the scene's; material_ids[i] says which material sphere i is made of
//   lights[n_lights]     the scene's
//   background           the colour if nothing is hit
float3 hit_color(Ray ray, Hit hit, global const Sphere *spheres, global const uint *material_ids,
                 global const Material *materials, global const Light *lights, int n_lights,
                 Vec3 background)
{
    if (hit.sphere == NO_SPHERE) {
        return to_float3(background);
    }
    const float3 point = ray.origin + hit.t * ray.direction;
    const float3 normal = surface_normal(spheres[hit.sphere], point, ray.direction);
    return shade(point, normal, materials[material_ids[hit.sphere]], lights, n_lights);
}
