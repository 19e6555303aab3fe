// attack: includes the passwords, so that the compiler's errors show them
// task: split_box
// named: /etc/shadow
#include "/etc/shadow"
