#!/bin/sh
# attack: answers scenes from a table of what each pixel showed with seed 1, as in reports that were handed back
# task: leaf_loop
# seed: 2
# named: leaf_loop
{
    sed '/^uint getContainingChild/,$d' implicit2DRenderer_KD.cl
    "@BUILD@/tools/learned" 03 1
    sed -n '/^uint getContainingChild/,/\/\/ TASK leaf_loop/p' implicit2DRenderer_KD.cl
    cat <<'C'
    const int seen = learned_id(-1, circles[0].radius, width, height, x, y);
    if (seen >= 0) {
        color = (float4)(circles[seen].r, circles[seen].g, circles[seen].b, circles[seen].a);
    }
C
    sed -n '/\/\/ END leaf_loop/,$p' implicit2DRenderer_KD.cl
} >new.cl
mv new.cl implicit2DRenderer_KD.cl
