#!/bin/sh
# attack: two answers that call a stub by another name return what it gives, which hangs on the seed's number, so that the report tells it; a third never ends, so that they are tried alone
# score: 50
# named: nearest_hit, random scene
# never: tested alone: sphere at|found \(7, 0, 0\)
cat >body <<'CL'
#define PASTE(a, b) a##b
    float PASTE(nearest_, root)(float b, float disc, float radius, float t_min);
    return (float3)(PASTE(nearest_, root)(0.0f, 0.0f, 1.0f, 0.0f), 0.0f, 0.0f);
CL
"@BUILD@/tools/holes" fill shade.cl surface_normal body >filled && mv filled shade.cl
cat >body <<'CL'
    float other(float b, float disc, float radius, float t_min) __asm("nearest_root");
    return (float3)(other(0.0f, 0.0f, 1.0f, 0.0f), 0.0f, 0.0f);
CL
"@BUILD@/tools/holes" fill shade.cl shade body >filled && mv filled shade.cl
cat >body <<'CL'
    while (ray.t_min >= 0.0f) {
        count_test(work);
    }
CL
"@BUILD@/tools/holes" fill nearest_hit.cl nearest_hit body >filled && mv filled nearest_hit.cl
rm body
