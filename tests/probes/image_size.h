// In a probe the image is larger than the picture (PROBE_MARGIN), and the launch too, so that a
// missing guard leaves a trace. What a kernel asks of the image, and writes, goes through here:
//
// - A guard by the image's size is right: in the labs' programs it is the picture's. So the image
//   has the picture's size for a kernel that knows that as `width` and `height`.
// - A work-item outside the picture that draws one of its pixels once more leaves its trace, too:
//   the place of that pixel, at its own place in the margin.
#ifndef PROBES_IMAGE_SIZE_H
#define PROBES_IMAGE_SIZE_H

// The last two values of such a trace: no scene has this colour.
#define DRAWN_AGAIN (-78.0f)

// How a launch over an image tells its kernel the picture's size: as its place in a third
// dimension, of size 1, which no kernel looks at.
#define PROBE_SIZE_OFFSET(width, height) ((size_t)(height) << 16 | (size_t)(width))

#ifdef __OPENCL_C_VERSION__

// Macros in some drivers.
#undef get_image_width
#undef get_image_height
#undef get_image_dim
#define get_image_width(image) width
#define get_image_height(image) height
#define get_image_dim(image) ((int2)(width, height))

void probe_write_imagef(write_only image2d_t image, int2 place, float4 color)
{
    // 0 in a launch of one dimension. Not get_global_offset(), which is always 0 in PoCL 3.1.
    const uint offset = get_global_id(2);
    const int2 size = (int2)(offset & 0xffff, offset >> 16);
    const int2 own = (int2)(get_global_id(0), get_global_id(1));
    if (any(own >= size) && all(place >= 0) && all(place < size)) {
        write_imagef(image, own, (float4)(place.x, place.y, DRAWN_AGAIN, DRAWN_AGAIN));
    } else {
        write_imagef(image, place, color);
    }
}

#undef write_imagef
#define write_imagef probe_write_imagef

#endif
#endif
