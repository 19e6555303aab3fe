// attack: a kernel includes what another student handed in
// task: overlaps_N_Nearer
// named: #include .*neighbour.*no answer needs it
#include "@NEIGHBOUR@"
