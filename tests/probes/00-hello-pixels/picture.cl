// Probe of lab 00: the student's kernel.
#include "image_size.h"

#include "gradient.cl"
