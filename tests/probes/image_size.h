// In a probe the image is larger than the picture (PROBE_MARGIN), so that a missing guard leaves a
// trace. A guard by the image's size is right as well: in the labs' programs both are the same. So
// what asks for it, where a kernel knows the picture's `width` and `height`, gets these.
#ifndef PROBES_IMAGE_SIZE_H
#define PROBES_IMAGE_SIZE_H

// Macros in some drivers.
#undef get_image_width
#undef get_image_height
#undef get_image_dim
#define get_image_width(image) width
#define get_image_height(image) height
#define get_image_dim(image) ((int2)(width, height))

#endif
