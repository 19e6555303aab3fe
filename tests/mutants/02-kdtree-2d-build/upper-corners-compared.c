// mutant: maxX and maxY are compared, not the lengths of the sides
// task: split_box
// caught by: split-longer
// says: maxX against maxY
if (box.maxX >= box.maxY) {
    left->maxX = right->minX = (box.minX + box.maxX) / 2;
} else {
    left->maxY = right->minY = (box.minY + box.maxY) / 2;
}
