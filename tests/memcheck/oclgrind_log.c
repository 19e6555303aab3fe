// Reading Oclgrind's log (see oclgrind_log.h). A message is a line that begins at the margin, and
// the lines below it that are indented:
//
//     Invalid read of size 4 at global memory address 0x1000000000020
//         Kernel: implicit2DRenderer
//         Entity: Global(5,0,0) Local(5,0,0) Group(0,0,0)
//           %2 = load float, float addrspace(1)* %arrayidx.i, align 4
//         At line 3 (column 12) of ./inc.cl:
//           return in[i + 3];
//
// A race has two such places. The line of source is wrong where an #include or a #line came before:
// it is looked up anew.
#include "oclgrind_log.h"

#include <stdio.h>
#include <string.h>

// What the first words of a message mean.
static const struct {
    const char *begins, *holds;  // either may be ""
    const char *says;
} kinds[] = {
    {"Invalid read", "global", "reads outside of a buffer: an index is too large or negative"},
    {"Invalid write", "global", "writes outside of a buffer: an index is too large or negative"},
    {"Invalid read", "constant", "reads outside of a buffer: an index is too large or negative"},
    {"Invalid read", "local", "reads outside of local memory: an index is too large or negative"},
    {"Invalid write", "local", "writes outside of local memory: an index is too large or negative"},
    {"Invalid read", "", "reads outside of an array or through a pointer that leads nowhere"},
    {"Invalid write", "", "writes outside of an array or through a pointer that leads nowhere"},
    {"Index (", "", "an array has no such index"},
    {"Uninitialized value", "written", "stores a value that was never set"},
    {"Uninitialized address", "", "uses an address or an index that was never set"},
    {"Controlflow depends", "", "decides by a value that was never set"},
    {"Uninitialized", "", "uses a value that was never set"},
    {"Instruction depends", "", "uses a value that was never set"},
    {"Read-write data race", "",
     "a race: one work-item reads what another writes, and nothing says which comes first"},
    {"Write-write data race", "",
     "a race: two work-items write to the same place, and nothing says which comes last"},
    {"Work-group divergence", "",
     "not all work-items of a group get to this barrier: they wait for ever on a GPU"},
};

static const char *meaning_of(const char *heading)
{
    for (size_t i = 0; i < sizeof kinds / sizeof *kinds; i++) {
        if (strncmp(heading, kinds[i].begins, strlen(kinds[i].begins)) == 0 &&
            strstr(heading, kinds[i].holds) != NULL) {
            return kinds[i].says;
        }
    }
    return NULL;
}

// "\tAt line 3 (column 12) of ./inc.cl:" to line and file.
static int place_read(const char *text, char file[FINDING_FILE_BYTES], int *line)
{
    int column;
    char path[FINDING_FILE_BYTES];
    if (sscanf(text, " At line %9d (column %9d) of %127[^\n]", line, &column, path) != 3) {
        return 0;
    }
    path[strcspn(path, ":")] = '\0';
    snprintf(file, FINDING_FILE_BYTES, "%s", strncmp(path, "./", 2) == 0 ? path + 2 : path);
    return 1;
}

// Take in an indented line of a message.
static void detail_read(Finding *finding, const char *text)
{
    const char *entity = strstr(text, "Global(");
    if (entity != NULL && finding->work_item[0] == '\0') {
        int x, y;
        if (sscanf(entity, "Global(%9d,%9d", &x, &y) == 2) {
            snprintf(finding->work_item, sizeof finding->work_item, "(%d, %d)", x, y);
        }
    }
    if (finding->file[0] == '\0') {
        place_read(text, finding->file, &finding->line);
    } else if (finding->other_file[0] == '\0') {
        place_read(text, finding->other_file, &finding->other_line);
    }
}

// Add a finding that is new. Returns how many there are then.
static int finding_add(Finding findings[MAX_FINDINGS], int n, const Finding *finding)
{
    for (int i = 0; i < n; i++) {
        if (findings[i].says == finding->says && findings[i].line == finding->line &&
            strcmp(findings[i].file, finding->file) == 0) {
            return n;
        }
    }
    if (n < MAX_FINDINGS) {
        findings[n++] = *finding;
    }
    return n;
}

int oclgrind_log_read(char *log, Finding findings[MAX_FINDINGS], int n)
{
    Finding finding = {0};
    char *rest = NULL;
    for (char *text = strtok_r(log, "\n", &rest); text != NULL;
         text = strtok_r(NULL, "\n", &rest)) {
        if (text[0] == '\t' || text[0] == ' ') {
            detail_read(&finding, text);
            continue;
        }
        n = finding.says ? finding_add(findings, n, &finding) : n;
        finding = (Finding){.says = meaning_of(text)};
    }
    return finding.says ? finding_add(findings, n, &finding) : n;
}
