#include "collision/query_sets.h"

#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "fixtures/collision_sets.h"
#if defined(VBSS_HAVE_ORACLE)
#include "oracle/oracle.h"
#endif

enum { MAX_FAMILIES = 24, MAX_SETS = MAX_FAMILIES + 5, MAX_PARTS = MAX_FAMILIES };
enum { FAMILY_QUERIES = 3000, DEGENERATE_QUERIES = 2000, QUICK_SHARE = 10 };
#define SEED 1

/* What a set is made of: all families, or the one at `which`. */
typedef enum set_source {
    THREAD,
    HARD_FAMILY,
    HARD,
    TRIANGLES,
    DEGENERATE_EDGES,
    DEGENERATE_POINTS
} set_source;

static struct {
    query_set set;
    set_source source;
    uint32_t which;
} sets[MAX_SETS];
static size_t set_count;

static void add_set(const char *name, set_source source, uint32_t which)
{
    query_set *set = &sets[set_count].set;
    size_t length = 0;
    for (const char *c = name; *c != '\0' && length + 1 < sizeof set->name; c++) {
        /* letters, digits, and one dash for what lies between */
        if (isalnum((unsigned char)*c)) {
            set->name[length++] = (char)tolower((unsigned char)*c);
        } else if (length > 0 && set->name[length - 1] != '-') {
            set->name[length++] = '-';
        }
    }
    set->name[length] = '\0';
    set->sort = source == TRIANGLES ? POINTS : source < TRIANGLES ? EDGES : THIN;
    sets[set_count].source = source;
    sets[set_count].which = which;
    set_count++;
}

static void list_sets(void)
{
    char name[64];
    add_set("thread", THREAD, 0);
    add_set("hard", HARD, 0);
    for (uint32_t i = 0; i < collision_family_count && i < MAX_FAMILIES; i++) {
        snprintf(name, sizeof name, "hard-%s", collision_family_names[i]);
        add_set(name, HARD_FAMILY, i);
    }
    add_set("triangles", TRIANGLES, 0);
    add_set("degenerate-edges", DEGENERATE_EDGES, 0);
    add_set("degenerate-points", DEGENERATE_POINTS, 0);
}

query_set *query_set_at(size_t index)
{
    if (set_count == 0) {
        list_sets();
    }
    return index < set_count ? &sets[index].set : NULL;
}

const char *query_set_missing(const query_set *set)
{
#if defined(VBSS_HAVE_ORACLE)
    (void)set;
    return NULL;
#else
    return set->sort == THIN ? "no GMP, which the truth comes from" : NULL;
#endif
}

/* ---- the parts of a set */

#if defined(VBSS_HAVE_ORACLE)
/* Of the numbers that are asked: the change of unit rounds those below the normal ones. */
static bool meets_in_metres(const collision_query *q)
{
    collision_query asked = *q;
    for (size_t k = 0; k < 12; k++) {
        asked.start[k] *= QUERY_MM;
        asked.end[k] *= QUERY_MM;
    }
    return oracle_meets(&asked);
}
#endif

static bool make_degenerate(uint32_t which, vbss_collision_pair_kind kind, uint32_t count,
                            collision_set *part)
{
#if defined(VBSS_HAVE_ORACLE)
    return collision_set_degenerate(which, kind, count, SEED, meets_in_metres, part);
#else
    (void)which, (void)kind, (void)count, (void)part;
    return false;
#endif
}

/* Fills parts; on failure `*made` of them are to be released. */
static bool make_parts(set_source source, uint32_t which, bool quick, collision_set *parts,
                       uint32_t *made)
{
    uint32_t share = quick ? QUICK_SHARE : 1;
    uint32_t first = 0, count = 1;
    if (source == HARD_FAMILY) {
        first = which;
    } else if (source == HARD) {
        count = collision_family_count;
    } else if (source == TRIANGLES) {
        count = collision_sheet_count;
    } else if (source != THREAD) {
        count = collision_degenerate_count;
    }
    bool good = count <= MAX_PARTS;
    for (*made = 0; good && *made < count; *made += good) {
        collision_set *part = &parts[*made];
        uint32_t index = first + *made;
        switch (source) {
        case THREAD:
            good = collision_set_thread(SEED, part);
            break;
        case TRIANGLES:
            good = collision_set_sheet(index, FAMILY_QUERIES / share, SEED, part);
            break;
        case DEGENERATE_EDGES:
            good = make_degenerate(index, VBSS_COLLISION_PAIR_EDGE_EDGE, DEGENERATE_QUERIES / share,
                                   part);
            break;
        case DEGENERATE_POINTS:
            good = make_degenerate(index, VBSS_COLLISION_PAIR_POINT_TRIANGLE,
                                   DEGENERATE_QUERIES / share, part);
            break;
        default:
            good = collision_set_family(index, FAMILY_QUERIES / share, SEED, part);
            break;
        }
    }
    return good;
}

/* ---- as methods take them */

static void release_set(query_set *set)
{
    free(set->metres);
    free(set->millimetres);
    free(set->start);
    free(set->end);
    free(set->truth);
    free(set->clearance);
    set->metres = set->millimetres = NULL;
    set->start = set->end = NULL;
    set->truth = NULL;
    set->clearance = NULL;
    set->made = false;
}

static bool allocate_set(query_set *set, size_t count)
{
    set->metres = calloc(count, sizeof *set->metres);
    set->millimetres = calloc(count, sizeof *set->millimetres);
    set->start = calloc(12 * count, sizeof *set->start);
    set->end = calloc(12 * count, sizeof *set->end);
    set->truth = calloc(count, sizeof *set->truth);
    set->clearance = calloc(count, sizeof *set->clearance);
    return set->metres != NULL && set->millimetres != NULL && set->start != NULL &&
           set->end != NULL && set->truth != NULL && set->clearance != NULL;
}

static void put_query(query_set *set, size_t i, size_t count, const collision_query *from)
{
    query *m = &set->metres[i], *mm = &set->millimetres[i];
    m->kind = mm->kind = from->kind;
    m->thickness = QUERY_MM * from->thickness;
    mm->thickness = from->thickness;
    for (size_t k = 0; k < 12; k++) {
        m->start[k] = set->start[k * count + i] = QUERY_MM * from->start[k];
        m->end[k] = set->end[k * count + i] = QUERY_MM * from->end[k];
        mm->start[k] = m->start[k] / QUERY_MM;
        mm->end[k] = m->end[k] / QUERY_MM;
    }
    set->truth[i] = from->hit;
    set->clearance[i] = from->clearance;
    set->positives += from->hit;
}

/* False when memory is short, and for a set that has more than one kind or D. */
static bool fill_set(query_set *set, const collision_set *parts, uint32_t part_count)
{
    size_t count = 0, i = 0;
    for (uint32_t p = 0; p < part_count; p++) {
        count += parts[p].count;
    }
    if (count == 0 || !allocate_set(set, count)) {
        return false;
    }
    const query *first = &set->metres[0];
    bool alike = true;
    for (uint32_t p = 0; p < part_count; p++) {
        for (uint32_t k = 0; k < parts[p].count; k++, i++) {
            put_query(set, i, count, &parts[p].queries[k]);
            alike = alike && set->metres[i].kind == first->kind &&
                    !(fabs(set->metres[i].thickness - first->thickness) > 0.0);
        }
    }
    set->rows = (query_rows){.kind = first->kind,
                             .count = (uint32_t)count,
                             .thickness = first->thickness,
                             .metres = set->metres,
                             .millimetres = set->millimetres,
                             .start = set->start,
                             .end = set->end};
    return alike;
}

bool query_set_make(query_set *set)
{
    size_t at = 0;
    while (&sets[at].set != set) {
        at++;
    }
    if (set->made) {
        return true;
    }
    collision_set parts[MAX_PARTS];
    memset(parts, 0, sizeof parts);
    uint32_t part_count;
    set->positives = 0;
    set->made = make_parts(sets[at].source, sets[at].which, set->quick, parts, &part_count) &&
                fill_set(set, parts, part_count);
    for (uint32_t p = 0; p < part_count; p++) {
        collision_set_release(&parts[p]);
    }
    if (!set->made) {
        release_set(set);
    }
    return set->made;
}

void query_sets_release(void)
{
    for (size_t i = 0; i < set_count; i++) {
        release_set(&sets[i].set);
    }
}
