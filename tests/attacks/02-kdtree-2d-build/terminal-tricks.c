// attack: escape sequences, script and markup where the report shows what was printed
// task: pack_leaf
// named: alert
    (void)tree, (void)id, (void)ids, (void)n_ids;
    puts("\033[2J\033]0;full marks\a\033[1;32m100/100\033[0m \b\b\b\r");
    puts("<script>alert(1)</script></pre><img src=x onerror=alert(1)> ]]> --> &amp;");
    puts("\xe2\x80\xae" "001/0 erocS \xc0\x80 \xff\xfe \xed\xa0\x80");
    exit(7);
