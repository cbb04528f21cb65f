/* Codes of known knots, for the tests of what reads codes: braids that are closed, sums, stacked throws; and
 * moves that change the diagram and not the knot. All are diagrams in the plane; `at` is the number of the
 * entry. Shares nothing with the library but the struct. */
#ifndef VBSS_TESTS_KNOT_CODES_H
#define VBSS_TESTS_KNOT_CODES_H

#include "knot/knot.h"

enum { CODES_MAX = 512, CODES_WORD = 12 }; /* crossings of a code, letters of a known braid */

/* The unknot without a crossing, with room for CODES_MAX. */
knot_gauss_code *codes_make(void);
void codes_free(knot_gauss_code *code);
void codes_set(knot_gauss_code *to, const knot_gauss_code *from);

/* The closure of a braid from the lower end of its first strand on: letter i crosses strands i and i + 1
 * (from 1), positive for a right-handed crossing. False, and the code as it was: more than one closed curve,
 * or too many letters. */
bool codes_braid(knot_gauss_code *code, const int *word, size_t letters);
/* T(p, q), p > 0: of p strands; left-handed for negative q. They have no common divisor. */
void codes_torus(knot_gauss_code *code, int p, int q);

/* Knots of the tables, with invariants in the library's conventions, of the closure of this very word. Words:
 * T. A. Gittings, "Minimum braids", arXiv math/0401051, some as their mirror image, as KnotInfo has them.
 * Tests compute the numbers by other ways too (Seifert's matrix, Jones' polynomial): v3 is from there. */
typedef struct codes_known {
    const char *name;
    int letters, word[CODES_WORD];
    int determinant, signature, v2, v3;
} codes_known;
enum { CODES_KNOWN = 22 };
extern const codes_known codes_table[CODES_KNOWN];
void codes_named(knot_gauss_code *code, const char *name);

/* The sum with another knot, tied into the curve just before an entry (0 to 2 n). */
void codes_tie(knot_gauss_code *code, uint32_t entry, const knot_gauss_code *other);
/* Throws on two limbs, from the inside out: each lies within the middle of the next, as twist.c wants it. */
void codes_throws(knot_gauss_code *code, uint32_t throws, const int *wraps, const int *signs);

/* All 210 sums of at most four throws of at most three wraps; `user` is handed on. Returns how many. */
typedef void (*codes_visit)(uint32_t throws, const int *wraps, const int *signs, void *user);
uint32_t codes_each_sum(codes_visit visit, void *user);

/* Mirror image, other direction, beginning at another entry. */
void codes_mirror(knot_gauss_code *code);
void codes_reverse(knot_gauss_code *code);
void codes_rotate(knot_gauss_code *code, uint32_t entry);

/* The number of the face on the left (side 0) and on the right (1) of the arc after an entry, at
 * faces[2 * entry + side]; 4 n numbers. Returns how many faces there are: n + 2. */
uint32_t codes_faces(const knot_gauss_code *code, uint32_t *faces);

/* Reidemeister's moves at random places: a loop more, a bigon more, a strand across a crossing. False: there is no
 * room, or no place for it. */
bool codes_move_1(knot_gauss_code *code, vbss_random *random);
bool codes_move_2(knot_gauss_code *code, vbss_random *random);
bool codes_move_3(knot_gauss_code *code, vbss_random *random);
/* All three until there are at least so many crossings, at most one more. */
void codes_grow(knot_gauss_code *code, vbss_random *random, uint32_t crossings);

#endif
