// Which seeds are for students at home: those below this bound.
//
// A handout's judge knows the answers and is asked as often as its owner likes, with any seed. For seeds
// of home it tells all that it knows of a mistake. For any other seed, which may be that of a grading,
// it says whether a check passes and what the mistake is, but no value and no picture: nobody can read a
// grading's answers off it and put them into a table. So a handout draws its seeds below the bound, and
// the course above (settings.c). Who tells: judge/judge.h.
#ifndef GRADER_HOME_SEEDS_H
#define GRADER_HOME_SEEDS_H

#define HOME_SEEDS 65536

#endif
