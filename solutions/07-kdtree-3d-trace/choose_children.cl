// Lab 07: at an inner node: which child comes first on the ray, and which does the ray meet at all?
// The plane is at right angles to an axis, so only one coordinate of the ray counts.
//
// Flow: scene -> buffers -> KERNEL -> image. Called by trace.cl.
#include "kdtree3d.h"

// The near child: the one on the eye's side of the plane. If the eye is on the plane, it is the one
// that the ray goes into.
//   origin    the ray's, along node.split_axis
//   inverse   1 / direction along that axis: only its sign counts. If the eye is on the plane and
//             the ray along it, either child is right: spheres that touch the plane are in both
// Returns 0 for the child with the lower coordinates, 1 for the other.
// Source: lecture, slide "Bestimme zu durchsuchende Childs".
uint near_side(KdNode3 node, float origin, float inverse)
{
    // TASK near_side: compare the eye with the plane. The direction counts only if they are equal.
    //> (void)node, (void)origin, (void)inverse;
    //> return 0;
    if (origin < node.split_pos) {
        return 0;
    }
    if (origin > node.split_pos) {
        return 1;
    }
    return inverse > 0.0f;
    // END near_side
}

enum { ONLY_NEAR, ONLY_FAR, BOTH };

// Which children does the ray meet inside this node?
//   origin        the ray's, along node.split_axis
//   inverse       1 / direction along that axis; infinite for a ray along the plane
//   t_min, t_max  the part of the ray inside the node
//   t_split       out, for BOTH: where the ray meets the plane; for the others it may be anything
// Returns ONLY_NEAR, ONLY_FAR or BOTH.
// Source: lecture, slides "Bestimme zu durchsuchende Childs" and "Begrenze Strahl für Child".
int children_on_ray(KdNode3 node, float origin, float inverse, float t_min, float t_max,
                    float *t_split)
{
    // TASK children_on_ray: the plane is behind the eye, before, in or beyond the node's part of
    // the ray. A ray along the plane never meets it.
    //> (void)node, (void)origin, (void)inverse, (void)t_min, (void)t_max, (void)t_split;
    //> return ONLY_NEAR;
    *t_split = (node.split_pos - origin) * inverse;
    // Along the plane t_split is infinite, or NaN if the eye is on it: never between the two.
    if (!(*t_split > 0.0f && *t_split <= t_max)) {
        return ONLY_NEAR;
    }
    return *t_split < t_min ? ONLY_FAR : BOTH;
    // END children_on_ray
}
