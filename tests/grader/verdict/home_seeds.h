// Which seeds are for students at home: those below this bound.
//
// A handout's judge knows the answers, and its owner may ask it as often as they like, with any
// seed. For a seed of home it says all that it knows of a mistake. For any other seed, which may be
// that of a grading, it says only whether a check passes. A value would be one entry of a table of
// that grading's answers. The sentence that names a mistake would be nearly as good: it goes away
// when one right entry of an answer is made wrong. So a handout draws its seeds below the bound,
// and the course above (settings.c). Who says it: judge/judge_tool.c.
#ifndef GRADER_HOME_SEEDS_H
#define GRADER_HOME_SEEDS_H

#define HOME_SEEDS 65536

#endif
