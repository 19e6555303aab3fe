// attack: writes nothing, and hopes that the memory still holds somebody's picture
// task: gradient
// named: written
    (void)width, (void)height, (void)image;
