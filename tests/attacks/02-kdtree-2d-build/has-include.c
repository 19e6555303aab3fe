// attack: asks the compiler which files there are
// task: split_box
// named: __has_include
#if __has_include("/etc/shadow") || __has_include("@NEIGHBOUR@") || __has_include("@REFERENCE@")
#error LEAKED: there is such a file
#endif
    (void)box;
