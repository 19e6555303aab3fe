// The window of a lab: what there is to show comes from common/follow/NN-name.c.
//
// Read next: view.c.
#include "view.h"

int main(int argc, char **argv)
{
    return view_run(argc, argv, &WORLD_LAB);
}
