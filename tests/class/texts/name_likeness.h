// Names that look like one person's: "Carol", "carol ", "carol-2", "Carol (2)", "carol" with
// a Cyrillic letter. Whose a grade is never depends on it: it tells an instructor where to look.
#ifndef CLASS_NAME_LIKENESS_H
#define CLASS_NAME_LIKENESS_H

#include <stdint.h>

// Room for a name, whose bytes may each be written as \xHH.
enum { ENTRY_NAME_BYTES = 1100 };

// What is left of a name for the eye: small letters and digits without accents, look-alikes of
// other scripts as the Latin letter, "0", "1" and "i" as "o", "l" and "l"; of scripts that look
// like nothing Latin the bytes as they are. "" where nothing is left.
void name_likeness(const char *name, char key[ENTRY_NAME_BYTES]);

// The length of a name before the number of an attempt, "-2", "_2" or " (2)" and blanks behind it;
// else its whole length.
int name_stem(const char *name);

// Does a name look like another, or like another's attempt: "carol-2" like "carol"?
int name_looks_like(const char *name, const char *other);

// A name composed (NFC): a Mac writes an accent apart from its letter. What is too long, or no
// text, stays as it is.
void name_compose(const char *name, char composed[ENTRY_NAME_BYTES]);

// Is there nothing to see of a character by itself: blanks of any width, controls, fillers, marks
// that only change others? What Unicode has not assigned counts as such, too. A name may be full of
// them, and a spreadsheet may pass over them.
int character_is_blank(uint32_t code);

#endif
