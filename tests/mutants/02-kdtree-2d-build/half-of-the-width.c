// mutant: across x the border is half of the width
// task: split_box
// caught by: split-middle
// says: half of a length
const float width = box.maxX - box.minX;
const float height = box.maxY - box.minY;
if (width >= height) {
    left->maxX = right->minX = width / 2;
} else {
    left->maxY = right->minY = box.minY + height / 2;
}
