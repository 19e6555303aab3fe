// attack: a picture of infinite numbers
// task: gradient
// score: 70
// named: (NaN|not a number|not finite|infinite)
    (void)width, (void)height;
    const float no_number = INFINITY;
    const int2 place = (int2)(get_global_id(0), get_global_id(1));
    if (place.x < width && place.y < height) {
        write_imagef(image, place, (float4)(no_number));
    }
