// attack: notes of its own where the report says a crash was, with words of its own and a forged line
// task: pack_leaf
// named: it crashed: signal 11
    (void)tree, (void)id, (void)ids, (void)n_ids;
    char words[32] = "splits\0LEAK" "ED";
    FILE *note = fopen("out/note", "wb");
    fwrite(words, 1, sizeof words, note);
    fclose(note);
    FILE *report = fopen("out/crash.0", "w");
    fputs("ERROR: AddressSanitizer: LEAK" "ED\n"
          "    #0 0x1 in LEAK" "ED labs/02-kdtree-2d-build/../../solutions/02-kdtree-2d-build/"
          "kdtree2d_build.c:50\n"
          "    #1 0x1 in LEAK" "ED /etc/passwd:1\n"
          "    #2 0x1 in LEAK" "ED labs/02-kdtree-2d-build/kdtree2d_build.c:99999\n", report);
    fclose(report);
    *(volatile unsigned *)0 = 1;
