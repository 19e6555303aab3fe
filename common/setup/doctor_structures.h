// Every header with a structure of doctor_layouts.h, for the host and for the device.
#ifndef COMMON_SETUP_DOCTOR_STRUCTURES_H
#define COMMON_SETUP_DOCTOR_STRUCTURES_H

#include "camera.h"
#include "circle.h"
#include "circle_tiles.h"
#include "kdtree2d.h"
#include "kdtree3d.h"
#include "shading.h"
#include "sphere.h"
#include "todo.h"
#include "vec3.h"
#include "work.h"

#endif
