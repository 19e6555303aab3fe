// attack: pretends to be another file, whose lines the compiler then shows beside its errors
// task: split_box
// named: #line
    (void)box;
#line 1 "@NEIGHBOUR@"
    this is no C;
#line 1 "/etc/shadow"
    this neither;
