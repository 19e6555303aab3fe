// attack: includes a file without an end
// task: split_box
// named: include .*/dev/zero
// limit: 2
#include "/dev/zero"
