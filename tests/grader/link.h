// Relative links between the pages of a grading, so that they can be moved together.
#ifndef GRADER_LINK_H
#define GRADER_LINK_H

// The link, as it stands in the page at page_path, to the file called `name` beside the file at
// path. Nothing in it needs escaping for HTML. Owned by the caller; NULL when there is no such
// file.
char *link_beside(const char *page_path, const char *path, const char *name);

#endif
