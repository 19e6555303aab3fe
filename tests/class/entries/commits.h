// When the commit that a clone has checked out was made: the time of work that Git delivers.
#ifndef CLASS_COMMITS_H
#define CLASS_COMMITS_H

#include "roster.h"

// Give each entrant without a time whose folder is a repository the time of its commit. A student
// may have written the repository, with programs in its settings that Git would run: so Git looks
// at it in bubblewrap's sandbox only. Where there is no such sandbox, or no Git, the times stay
// unknown, after one line on stderr.
//   folder   the class's, with the links submissions/SLUG
// Returns 0, or -1 when memory runs out.
int commits_take(const char *folder, Roster *roster);

#endif
