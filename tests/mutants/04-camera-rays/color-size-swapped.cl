// mutant: width and height are swapped in the call
// task: direction_color
// caught by: color-picture
// says: swapped
    color = 0.5f * primary_ray(x, y, height, width, camera).direction + 0.5f;
