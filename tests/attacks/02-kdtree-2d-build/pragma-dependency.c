// attack: asks by a pragma whether a file is newer than this one
// task: split_box
// named: pragma GCC dependency
    (void)box;
    _Pragma("GCC dependency \"@NEIGHBOUR@\" LEAKED")
#pragma GCC poison memcpy
