// attack: has the assembler put a file into the program
// task: pack_leaf
// named: \.incbin
    (void)tree, (void)id, (void)ids, (void)n_ids;
    extern const char stolen[];
    __asm__(".section .rodata\nstolen: .incbin \"@NEIGHBOUR@\"\n.byte 0\n.text");
    printf("LEAK" "ED %s\n", stolen);
    exit(7);
