// attack: includes a file without an end
// task: split_box
// named: include .*/dev/zero
// limit: 3
#include "/dev/zero"
