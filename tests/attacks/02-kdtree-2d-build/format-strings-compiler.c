// attack: the same, in the compiler's mouth
// task: pack_leaf
// named: %n%n%s%s
#error %n%n%s%s%100000000d <script>alert(1)</script>
