// What messages say of points, boxes, circles and spheres: each as text in a structure of its own,
// to be used as words_box3d(box).text in the arguments of message_new().
#ifndef JUDGE_WORDS_H
#define JUDGE_WORDS_H

#include "circle.h"
#include "kdtree2d.h"
#include "kdtree3d.h"
#include "sphere.h"
#include "vec3.h"

typedef struct Words {
    char text[160];
} Words;

// As printf() has it.
__attribute__((format(printf, 1, 2))) Words words(const char *format, ...);

Words words_xyz(double x, double y, double z, int digits);  // "(1, 2, 3)"
Words words_vec3(Vec3 v, int digits);                       // the same
// With as many digits as it takes to tell it from every other float: "0.1", "0.100000009".
Words words_float(float value);

Words words_rgba(u32 color);        // "red 158 green 55 blue 121 alpha 255"; red is lowest
Words words_circle(Circle circle);  // "(1, 2) radius 3"
Words words_sphere(Sphere sphere);  // "(1, 2, 3) radius 4"
Words words_box2d(BBox2D box);      // "x [1, 2] y [3, 4]"
Words words_box3d(BBox3D box);      // "x [1, 2] y [3, 4] z [5, 6]"

#endif
