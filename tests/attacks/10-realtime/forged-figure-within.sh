#!/bin/sh
# attack: forged-figure.cl with a figure within the limits, 12 times, which nobody can tell from a measured one
# task: cone_misses_sphere
# named: "value": 12\.0
# score: 100
# In the place of 1e300 ms.
sed 's/0x7e37e43c8800759cUL/0x4028000000000000UL/' "@COURSE@/tests/attacks/10-realtime/forged-figure.cl" >body
"@BUILD@/tools/holes" fill cone.cl cone_misses_sphere body >filled && mv filled cone.cl
rm body
