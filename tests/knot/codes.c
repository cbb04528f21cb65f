#include "knot/codes.h"

#include <stdlib.h>
#include <string.h>

/* ---- room */

static void *or_abort(void *block)
{
    if (block == NULL) {
        abort();
    }
    return block;
}

knot_gauss_code *codes_make(void)
{
    knot_gauss_code *code = or_abort(calloc(1, sizeof *code));
    code->capacity = CODES_MAX;
    code->crossing = or_abort(calloc(2 * (size_t)CODES_MAX, sizeof *code->crossing));
    code->over = or_abort(calloc(2 * (size_t)CODES_MAX, sizeof *code->over));
    code->position = or_abort(calloc(2 * (size_t)CODES_MAX, sizeof *code->position));
    code->sign = or_abort(calloc(CODES_MAX, sizeof *code->sign));
    code->scratch = or_abort(calloc(4 * (size_t)CODES_MAX, sizeof *code->scratch));
    return code;
}

void codes_free(knot_gauss_code *code)
{
    free(code->crossing);
    free(code->over);
    free(code->position);
    free(code->sign);
    free(code->scratch);
    free(code);
}

void codes_set(knot_gauss_code *to, const knot_gauss_code *from)
{
    if (from->n > to->capacity) {
        abort();
    }
    to->n = from->n;
    memcpy(to->crossing, from->crossing, 2 * (size_t)from->n * sizeof *to->crossing);
    memcpy(to->over, from->over, 2 * (size_t)from->n * sizeof *to->over);
    memcpy(to->position, from->position, 2 * (size_t)from->n * sizeof *to->position);
    memcpy(to->sign, from->sign, (size_t)from->n * sizeof *to->sign);
}

static void number_places(knot_gauss_code *code)
{
    for (uint32_t e = 0; e < 2 * code->n; e++) {
        code->position[e] = (double)e;
    }
}

/* Entries move up to leave a gap of `count` before `entry`. */
static void open_gap(knot_gauss_code *code, uint32_t entry, uint32_t count)
{
    size_t behind = 2 * (size_t)code->n - entry;
    memmove(code->crossing + entry + count, code->crossing + entry,
            behind * sizeof *code->crossing);
    memmove(code->over + entry + count, code->over + entry, behind * sizeof *code->over);
}

static void put(knot_gauss_code *code, uint32_t entry, uint32_t crossing, bool over)
{
    code->crossing[entry] = (uint16_t)crossing;
    code->over[entry] = over ? 1 : 0;
}

/* ---- braids */

/* Strands go up. A right-handed crossing: the one from the lower left is over. */
bool codes_braid(knot_gauss_code *code, const int *word, size_t letters)
{
    if (letters > code->capacity) {
        return false;
    }
    size_t met = 0, strand = 0;
    do {
        for (size_t i = 0; i < letters; i++) {
            size_t left = (size_t)abs(word[i]) - 1;
            if (strand == left || strand == left + 1) {
                if (met < 2 * letters) {
                    put(code, (uint32_t)met, (uint32_t)i, (strand == left) == (word[i] > 0));
                }
                met++;
                strand = strand == left ? left + 1 : left;
            }
        }
    } while (strand != 0);
    if (met != 2 * letters) {
        return false;
    }
    code->n = (uint32_t)letters;
    for (size_t i = 0; i < letters; i++) {
        code->sign[i] = word[i] > 0 ? 1 : -1;
    }
    number_places(code);
    return true;
}

void codes_torus(knot_gauss_code *code, int p, int q)
{
    int word[CODES_MAX], count = 0;
    for (int turn = 0; turn < abs(q); turn++) {
        for (int i = 1; i < p && count < CODES_MAX; i++) {
            word[count++] = q > 0 ? i : -i;
        }
    }
    if (!codes_braid(code, word, (size_t)count)) {
        abort();
    }
}

const codes_known codes_table[CODES_KNOWN] = {
    {"3_1", 3, {1, 1, 1}, 3, -2, 1, 1},
    {"4_1", 4, {1, -2, 1, -2}, 5, 0, -1, 0},
    {"5_1", 5, {1, 1, 1, 1, 1}, 5, -4, 3, 5},
    {"5_2", 6, {1, 1, 1, 2, -1, 2}, 7, -2, 2, 3},
    {"6_1", 7, {1, 1, 2, -1, -3, 2, -3}, 9, 0, -2, -1},
    {"6_2", 6, {1, 1, 1, -2, 1, -2}, 11, -2, -1, -1},
    {"6_3", 6, {1, 1, -2, 1, -2, -2}, 13, 0, 1, 0},
    {"7_1", 7, {1, 1, 1, 1, 1, 1, 1}, 7, -6, 6, 14},
    {"7_2", 9, {1, 1, 1, 2, -1, 2, 3, -2, 3}, 11, -2, 3, 6},
    {"7_3", 8, {1, 1, 1, 1, 1, 2, -1, 2}, 13, -4, 5, 11},
    {"7_4", 9, {1, 1, 2, -1, 2, 2, 3, -2, 3}, 15, -2, 4, 8},
    {"7_5", 8, {1, 1, 1, 1, 2, -1, 2, 2}, 17, -4, 4, 8},
    {"7_6", 7, {1, 1, -2, 1, 3, -2, 3}, 19, -2, 1, 2},
    {"7_7", 7, {1, -2, 1, -2, 3, -2, 3}, 21, 0, -1, -1},
    {"8_18", 8, {1, -2, 1, -2, 1, -2, 1, -2}, 45, 0, 1, 0},
    {"8_19", 8, {1, 1, 1, 2, 1, 1, 1, 2}, 3, -6, 5, 10},
    {"8_20", 8, {1, 1, 1, -2, -1, -1, -1, -2}, 9, 0, 2, -2},
    {"8_21", 8, {1, 1, 1, 2, -1, -1, 2, 2}, 15, -2, 0, -1},
    {"10_62", 10, {1, 1, 1, 1, -2, 1, 1, 1, -2, -2}, 45, -4, 5, 9},
    {"10_124", 10, {1, 1, 1, 1, 1, 2, 1, 1, 1, 2}, 1, -8, 8, 20},
    {"10_132", 11, {1, 1, 1, -2, -1, -1, -2, -3, 2, -3, -3}, 5, 0, 3, -5},
    {"10_140", 11, {1, 1, 1, -2, -1, -1, -1, -2, -3, 2, -3}, 9, 0, 2, -4},
};

void codes_named(knot_gauss_code *code, const char *name)
{
    for (size_t i = 0; i < CODES_KNOWN; i++) {
        const codes_known *known = &codes_table[i];
        if (strcmp(known->name, name) == 0 &&
            codes_braid(code, known->word, (size_t)known->letters)) {
            return;
        }
    }
    abort();
}

/* ---- sums */

void codes_tie(knot_gauss_code *code, uint32_t entry, const knot_gauss_code *other)
{
    if (code->n + other->n > code->capacity) {
        abort();
    }
    open_gap(code, entry, 2 * other->n);
    for (uint32_t e = 0; e < 2 * other->n; e++) {
        put(code, entry + e, code->n + other->crossing[e], other->over[e] != 0);
    }
    memcpy(code->sign + code->n, other->sign, other->n * sizeof *code->sign);
    code->n += other->n;
    number_places(code);
}

void codes_throws(knot_gauss_code *code, uint32_t throws, const int *wraps, const int *signs)
{
    knot_gauss_code *inside = codes_make();
    code->n = 0;
    for (uint32_t i = 0; i < throws; i++) {
        codes_set(inside, code);
        codes_torus(code, 2, signs[i] * (2 * wraps[i] + 1));
        codes_tie(code, code->n, inside);
    }
    codes_free(inside);
}

uint32_t codes_each_sum(codes_visit visit, void *user)
{
    static const int kinds[] = {1, -1, 2, -2, 3, -3};
    uint32_t count = 0;
    for (uint32_t number = 0; number < 7 * 7 * 7 * 7; number++) { /* digits ascend; 6: no throw */
        uint32_t digits[4] = {number / 343, number / 49 % 7, number / 7 % 7, number % 7},
                 throws = 0;
        int wraps[4], signs[4];
        if (digits[0] > digits[1] || digits[1] > digits[2] || digits[2] > digits[3]) {
            continue;
        }
        for (; throws < 4 && digits[throws] < 6; throws++) {
            wraps[throws] = abs(kinds[digits[throws]]);
            signs[throws] = kinds[digits[throws]] > 0 ? 1 : -1;
        }
        visit(throws, wraps, signs, user);
        count++;
    }
    return count;
}

/* ---- the same diagram seen otherwise */

void codes_mirror(knot_gauss_code *code)
{
    for (uint32_t e = 0; e < 2 * code->n; e++) {
        code->over[e] ^= 1;
    }
    for (uint32_t c = 0; c < code->n; c++) {
        code->sign[c] = (int8_t)-code->sign[c];
    }
}

static void swap_entries(knot_gauss_code *code, uint32_t a, uint32_t b)
{
    uint16_t crossing = code->crossing[a];
    uint8_t over = code->over[a];
    put(code, a, code->crossing[b], code->over[b] != 0);
    put(code, b, crossing, over != 0);
}

static void reverse_part(knot_gauss_code *code, uint32_t begin, uint32_t end)
{
    for (; begin + 1 < end; begin++, end--) {
        swap_entries(code, begin, end - 1);
    }
}

void codes_reverse(knot_gauss_code *code)
{
    reverse_part(code, 0, 2 * code->n);
}

void codes_rotate(knot_gauss_code *code, uint32_t entry)
{
    reverse_part(code, 0, entry);
    reverse_part(code, entry, 2 * code->n);
    reverse_part(code, 0, 2 * code->n);
}

/* ---- faces: sides of arcs that meet in a corner of a crossing belong together */

static uint32_t mate_of(const knot_gauss_code *code, uint32_t entry)
{
    uint32_t mate = 0;
    while (mate == entry || code->crossing[mate] != code->crossing[entry]) {
        mate++;
    }
    return mate;
}

static void join(uint32_t *faces, uint32_t count, uint32_t a, uint32_t b)
{
    uint32_t from = faces[a], to = faces[b];
    for (uint32_t i = 0; i < count; i++) {
        faces[i] = faces[i] == from ? to : faces[i];
    }
}

uint32_t codes_faces(const knot_gauss_code *code, uint32_t *faces)
{
    uint32_t entries = 2 * code->n, sides = 2 * entries, count = 0;
    for (uint32_t i = 0; i < sides; i++) {
        faces[i] = i;
    }
    for (uint32_t e = 0; e < entries; e++) {
        /* Each crossing once: from the strand that the other crosses from right to left. */
        if ((code->over[e] != 0) == (code->sign[code->crossing[e]] > 0)) {
            uint32_t mate = mate_of(code, e);
            uint32_t before = (e + entries - 1) % entries,
                     before_mate = (mate + entries - 1) % entries;
            join(faces, sides, 2 * e, 2 * mate + 1);
            join(faces, sides, 2 * e + 1, 2 * before_mate + 1);
            join(faces, sides, 2 * mate, 2 * before);
            join(faces, sides, 2 * before_mate, 2 * before + 1);
        }
    }
    /* Numbers without gaps. */
    uint32_t *number = or_abort(calloc(sides + 1, sizeof *number));
    for (uint32_t i = 0; i < sides; i++) {
        if (number[faces[i]] == 0) {
            number[faces[i]] = ++count;
        }
    }
    for (uint32_t i = 0; i < sides; i++) {
        faces[i] = number[faces[i]] - 1;
    }
    free(number);
    return code->n == 0 ? 2 : count;
}

/* ---- moves */

bool codes_move_1(knot_gauss_code *code, vbss_random *random)
{
    if (code->n == code->capacity) {
        return false;
    }
    uint32_t entry = vbss_random_below(random, 2 * code->n + 1), c = code->n;
    bool over = vbss_random_below(random, 2) != 0;
    open_gap(code, entry, 2);
    put(code, entry, c, over);
    put(code, entry + 1, c, !over);
    code->sign[c] = vbss_random_below(random, 2) != 0 ? 1 : -1;
    code->n++;
    number_places(code);
    return true;
}

/* Arc a is pushed over or under arc b out of the face that is on these sides of both. It meets the new crossings c
 * and c + 1 in this order, and so does b if both run in the same direction along the face. */
static void push(knot_gauss_code *code, const uint32_t arcs[2], const uint32_t sides[2], bool over)
{
    uint32_t a = arcs[0] + 1, b = arcs[1] + 1, c = code->n;
    bool is_parallel = sides[0] != sides[1];
    uint32_t later = a > b ? a : b, sooner = a > b ? b : a;
    open_gap(code, later, 4);
    memmove(code->crossing + sooner + 2, code->crossing + sooner,
            (later - sooner) * sizeof *code->crossing);
    memmove(code->over + sooner + 2, code->over + sooner, later - sooner);
    a += a == later ? 2 : 0;
    b += b == later ? 2 : 0;
    put(code, a, c, over);
    put(code, a + 1, c + 1, over);
    put(code, b, is_parallel ? c : c + 1, !over);
    put(code, b + 1, is_parallel ? c + 1 : c, !over);
    /* Seen along b, a first goes away from the face. */
    code->sign[c] = (sides[1] == 0) == over ? 1 : -1;
    code->sign[c + 1] = (int8_t)-code->sign[c];
    code->n += 2;
    number_places(code);
}

bool codes_move_2(knot_gauss_code *code, vbss_random *random)
{
    if (code->n == 0 || code->n + 2 > code->capacity) {
        return false;
    }
    uint32_t count = 4 * code->n, found = 0, b = 0;
    uint32_t *faces = or_abort(calloc(count, sizeof *faces));
    codes_faces(code, faces);
    uint32_t a = vbss_random_below(random, count);
    for (uint32_t i = 0; i < count; i++) { /* one of the other sides of the face, each as likely */
        if (i / 2 != a / 2 && faces[i] == faces[a] && vbss_random_below(random, ++found) == 0) {
            b = i;
        }
    }
    free(faces);
    if (found > 0) {
        const uint32_t arcs[2] = {a / 2, b / 2}, sides[2] = {a % 2, b % 2};
        push(code, arcs, sides, vbss_random_below(random, 2) != 0);
    }
    return found > 0;
}

/* Whether the arcs make a triangle of three strands, one of which is over and one under both others. */
static bool is_open_triangle(const knot_gauss_code *code, const uint32_t arcs[3])
{
    int overs[3] = {0, 0, 0}, tops = 0, bottoms = 0;
    for (int i = 0; i < 3; i++) {
        uint32_t begin = arcs[i], end = (begin + 1) % (2 * code->n);
        if (code->crossing[begin] == code->crossing[end]) {
            return false;
        }
        for (int j = 0; j < 3; j++) { /* no two arcs in a row */
            if (arcs[j] == end) {
                return false;
            }
        }
        overs[i] = code->over[begin] + code->over[end];
        tops += overs[i] == 2 ? 1 : 0;
        bottoms += overs[i] == 0 ? 1 : 0;
    }
    return tops == 1 && bottoms == 1;
}

bool codes_move_3(knot_gauss_code *code, vbss_random *random)
{
    uint32_t entries = 2 * code->n, found = 0, chosen[3] = {0, 0, 0};
    uint32_t *faces = or_abort(calloc(2 * (size_t)entries + 1, sizeof *faces));
    uint32_t count = codes_faces(code, faces);
    for (uint32_t f = 0; f < count && code->n > 2; f++) {
        uint32_t arcs[3] = {0, 0, 0}, corners = 0;
        for (uint32_t i = 0; i < 2 * entries; i++) {
            if (faces[i] == f) {
                arcs[corners < 3 ? corners : 0] = i / 2;
                corners++;
            }
        }
        if (corners == 3 && is_open_triangle(code, arcs) &&
            vbss_random_below(random, ++found) == 0) {
            memcpy(chosen, arcs, sizeof chosen);
        }
    }
    free(faces);
    for (int i = 0; i < 3 && found > 0; i++) {
        swap_entries(code, chosen[i], (chosen[i] + 1) % entries);
    }
    return found > 0;
}

void codes_grow(knot_gauss_code *code, vbss_random *random, uint32_t crossings)
{
    while (code->n < crossings) {
        uint32_t kind = vbss_random_below(random, 8);
        if (kind == 0 || code->n == 0) {
            (void)codes_move_1(code, random);
        } else if (kind < 4) {
            (void)codes_move_2(code, random);
        } else {
            (void)codes_move_3(code, random);
        }
    }
}
