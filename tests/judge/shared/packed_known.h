// Known mistakes of a packed leaf's ids (labs 02 and 06), for a file whose GIVEN (known.h) declares
// the PackJob `in` and the `list` that was found.
#ifndef JUDGE_PACKED_KNOWN_H
#define JUDGE_PACKED_KNOWN_H

#include "known.h"
#include "packed_list.h"

KNOWN_LIST(packed_known)
{
    GIVEN;

    EACH(reversed, is_reversed(list, in->ids, in->n_ids),
         "the ids stand there from the last to the first, and must ascend");
    EACH(positions, are_positions(list, in->n_ids),
         "those are positions in the list that was given, not its ids");
    EACH(in_bytes, is_copied_in_bytes(list, in->ids, in->n_ids),
         "as many bytes were copied as there are ids");
    EACH(ids_of_8_bits, is_cut(list, in->ids, in->n_ids, 0xff), "of each id 8 bits are there");
    EACH(ids_of_16_bits, is_cut(list, in->ids, in->n_ids, 0xffff), "of each id 16 bits are there");
    return NO_MORE;
}

#endif
