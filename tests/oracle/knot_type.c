/* Steps: close the curve, project it along a fixed sequence of generic directions, read off the Gauss
 * diagram, check that it can be drawn in the plane, take away what Reidemeister's first two moves can, and
 * count. */
#include "oracle/knot_type.h"

#include "base/random.h"

#include <stdlib.h>
#include <string.h>

enum { MAX_CROSSINGS = 1024, MAX_LEFT = 256, PROJECTIONS = 8, CLOSING_POINTS = 3 };

/* A passage of the curve through a crossing. */
typedef struct pass {
    double place; /* along the curve: segment plus share */
    int mate;     /* the other one through the same crossing */
    int sign;     /* of the crossing: over x under, seen from above */
    bool over;
    int next, previous; /* around the curve */
} pass;

typedef struct diagram {
    int count;
    pass passes[2 * MAX_CROSSINGS];
} diagram;

typedef struct work {
    diagram found, diagram;
    int map[4 * MAX_CROSSINGS];
    uint32_t matrix[MAX_LEFT][MAX_LEFT];
    vec3 points[]; /* closed curve, and the same turned */
} work;

/* ---- closing the curve, whose extent becomes 1 */

#define FAR_AWAY 10.0

/* False: all points are one, or some are no numbers. */
static bool close_curve(const vec3 *x, size_t n, vec3 *closed)
{
    vec3 middle = vec3_zero();
    double extent = 0.0;
    for (size_t i = 0; i < n; i++) {
        middle = vec3_add_scaled(middle, 1.0 / (double)n, x[i]);
    }
    for (size_t i = 0; i < n; i++) {
        extent = vbss_max(extent, vec3_distance(x[i], middle));
    }
    if (!(extent > 0.0 && extent <= DBL_MAX)) {
        return false;
    }
    for (size_t i = 0; i < n; i++) {
        closed[i] = vec3_scale(vec3_sub(x[i], middle), 1.0 / extent);
    }
    vec3 first = vec3_unit_or(closed[0], vec3_make(-1.0, 0.0, 0.0));
    vec3 last = vec3_unit_or(closed[n - 1], vec3_make(1.0, 0.0, 0.0));
    /* A corner square to both: the way between them stays far away. */
    vec3 square = vec3_cross(first, last);
    vec3 corner = vec3_norm(square) > 1e-3 ? vec3_unit_or(square, first) : vec3_any_normal(first);
    closed[n] = vec3_scale(last, FAR_AWAY);
    closed[n + 1] = vec3_scale(corner, FAR_AWAY);
    closed[n + 2] = vec3_scale(first, FAR_AWAY);
    return true;
}

/* The k-th direction up, and its points with the first repeated. */
static void turn(const vec3 *closed, size_t count, uint64_t k, vec3 *turned)
{
    vbss_random random;
    vbss_random_seed(&random, 1975, k);
    vec3 up = vbss_random_direction(&random);
    vec3 right = vec3_unit_or(vec3_cross(vbss_random_direction(&random), up), up);
    vec3 ahead = vec3_cross(up, right);
    for (size_t i = 0; i <= count; i++) {
        vec3 p = closed[i % count];
        turned[i] = vec3_make(vec3_dot(right, p), vec3_dot(ahead, p), vec3_dot(up, p));
    }
}

/* ---- crossings of a projection along z */

/* What is too near to be told: a vertex, in shares of the segment; rounding of products; the other strand
 * above. */
#define NEAR_VERTEX 1e-6
#define ROUNDING 1e-13
#define NEAR_HEIGHT 1e-9

typedef enum meeting { APART, CROSSING, DEGENERATE } meeting;

/* Whether numerator / d, d >= 0, lies between 0 and 1. */
static meeting within(double numerator, double d)
{
    double margin = NEAR_VERTEX * d + ROUNDING;
    if (numerator < -margin || numerator > d + margin) {
        return APART;
    }
    return numerator > margin && numerator < d - margin ? CROSSING : DEGENERATE;
}

static double cross_z(vec3 a, vec3 b)
{
    return a.x * b.y - a.y * b.x;
}

/* Of segments from p and q on; both passes get shares of their segments. */
static meeting meet(const vec3 *p, const vec3 *q, pass both[2])
{
    vec3 along_p = vec3_sub(p[1], p[0]), along_q = vec3_sub(q[1], q[0]);
    vec3 between = vec3_sub(q[0], p[0]);
    double d = cross_z(along_p, along_q), sense = d < 0.0 ? -1.0 : 1.0;
    double at_p = sense * cross_z(between, along_q), at_q = sense * cross_z(between, along_p);
    meeting in_p = within(at_p, fabs(d)), in_q = within(at_q, fabs(d));
    if (in_p != CROSSING || in_q != CROSSING) {
        return in_p == APART || in_q == APART ? APART : DEGENERATE;
    }
    double s = at_p / fabs(d), t = at_q / fabs(d);
    double above = p[0].z + s * along_p.z - (q[0].z + t * along_q.z);
    int sign = d * above > 0.0 ? 1 : -1;
    both[0] = (pass){.place = s, .sign = sign, .over = above > 0.0};
    both[1] = (pass){.place = t, .sign = sign, .over = above < 0.0};
    return fabs(above) > NEAR_HEIGHT ? CROSSING : DEGENERATE;
}

static bool boxes_apart(const vec3 *p, const vec3 *q)
{
    return (p[0].x < q[0].x && p[0].x < q[1].x && p[1].x < q[0].x && p[1].x < q[1].x) ||
           (p[0].x > q[0].x && p[0].x > q[1].x && p[1].x > q[0].x && p[1].x > q[1].x) ||
           (p[0].y < q[0].y && p[0].y < q[1].y && p[1].y < q[0].y && p[1].y < q[1].y) ||
           (p[0].y > q[0].y && p[0].y > q[1].y && p[1].y > q[0].y && p[1].y > q[1].y);
}

/* x[count] is x[0]. False: degenerate, or too many. */
static bool find_crossings(const vec3 *x, size_t count, diagram *d)
{
    d->count = 0;
    for (size_t i = 0; i < count; i++) {
        for (size_t j = i + 2; j < count - (i == 0 ? 1 : 0); j++) {
            if (boxes_apart(x + i, x + j)) {
                continue;
            }
            pass both[2];
            meeting how = meet(x + i, x + j, both);
            if (how == DEGENERATE || d->count == 2 * MAX_CROSSINGS) {
                return false;
            }
            if (how == CROSSING) {
                both[0].place += (double)i;
                both[1].place += (double)j;
                both[0].mate = d->count + 1;
                both[1].mate = d->count;
                memcpy(d->passes + d->count, both, sizeof both);
                d->count += 2;
            }
        }
    }
    return true;
}

/* ---- the diagram: passes in the order of the curve */

static int by_place(const void *a, const void *b)
{
    double p = ((const pass *)a)->place, q = ((const pass *)b)->place;
    return (p > q) - (p < q);
}

/* The mate of found[i] stands beside it. */
static void put_in_order(const diagram *found, int *map, diagram *d)
{
    d->count = found->count;
    for (int i = 0; i < found->count; i++) {
        d->passes[i] = found->passes[i];
        d->passes[i].mate = i; /* for now: where it stood */
    }
    qsort(d->passes, (size_t)d->count, sizeof d->passes[0], by_place);
    for (int i = 0; i < d->count; i++) {
        map[d->passes[i].mate] = i;
    }
    for (int i = 0; i < d->count; i++) {
        pass *p = &d->passes[i];
        p->mate = map[p->mate ^ 1];
        p->next = (i + 1) % d->count;
        p->previous = (i + d->count - 1) % d->count;
    }
}

/* Along one side of an arc, with the face on the left, to the next. Arc 2 i goes from pass i to the next,
 * arc 2 i + 1 is the way back. */
static int next_side(const diagram *d, int side)
{
    bool forward = side % 2 == 0;
    int here = forward ? d->passes[side / 2].next : side / 2;
    const pass *p = &d->passes[here];
    /* Seen along the curve's own direction, the other strand goes from right to left: */
    bool leftward = p->over == (p->sign > 0);
    return leftward == forward ? 2 * p->mate : 2 * d->passes[p->mate].previous + 1;
}

/* Euler: a connected diagram of c crossings in the plane has c + 2 faces. */
static bool is_planar(const diagram *d, int *seen)
{
    int faces = 0;
    memset(seen, 0, 2 * (size_t)d->count * sizeof *seen);
    for (int begin = 0; begin < 2 * d->count; begin++) {
        faces += seen[begin] == 0 ? 1 : 0;
        for (int side = begin; seen[side] == 0; side = next_side(d, side)) {
            seen[side] = 1;
        }
    }
    return d->count == 0 || faces == d->count / 2 + 2;
}

/* ---- taking away loops and bigons */

static void drop(diagram *d, int i)
{
    pass *p = &d->passes[i];
    d->passes[p->previous].next = p->next;
    d->passes[p->next].previous = p->previous;
    p->next = p->previous = -1;
}

/* At pass i and its next. */
static bool take_away(diagram *d, int i)
{
    const pass *p = d->passes;
    int j = p[i].next, mate = p[i].mate, mate_j = p[j].mate;
    if (j == mate) {
        drop(d, i);
        drop(d, j);
        return true;
    }
    if (p[i].over != p[j].over || p[i].sign == p[j].sign ||
        (p[mate].next != mate_j && p[mate_j].next != mate)) {
        return false;
    }
    drop(d, i);
    drop(d, j);
    drop(d, mate);
    drop(d, mate_j);
    return true;
}

static void reduce(diagram *d, int *map)
{
    bool again = true;
    while (again) {
        again = false;
        for (int i = 0; i < d->count; i++) {
            again = (d->passes[i].next >= 0 && take_away(d, i)) || again;
        }
    }
    int left = 0;
    for (int i = 0; i < d->count; i++) {
        map[i] = left;
        left += d->passes[i].next >= 0 ? 1 : 0;
    }
    for (int i = 0; i < d->count; i++) {
        pass p = d->passes[i];
        if (p.next >= 0) {
            p.mate = map[p.mate];
            d->passes[map[i]] = p;
        }
    }
    d->count = left; /* next and previous are not read any more */
}

/* ---- determinant: of the colouring matrix without its last row and column, modulo a prime */

#define PRIME 2147483647u

static uint32_t times(uint32_t a, uint32_t b)
{
    return (uint32_t)((uint64_t)a * b % PRIME);
}

static uint32_t inverse(uint32_t a)
{
    uint32_t result = 1;
    for (uint32_t power = PRIME - 2; power > 0; power >>= 1) {
        result = (power & 1) != 0 ? times(result, a) : result;
        a = times(a, a);
    }
    return result;
}

static void add_to(uint32_t *entry, uint32_t value)
{
    *entry = (uint32_t)(((uint64_t)*entry + value) % PRIME);
}

/* A row a crossing, in the order of passes under; a column an arc between passes under. */
static int fill_matrix(const diagram *d, int *arcs, uint32_t (*a)[MAX_LEFT])
{
    int size = d->count / 2, arc = 0, row = 0;
    for (int i = 0; i < d->count; i++) {
        arcs[i] = arc; /* that arrives */
        arc += d->passes[i].over ? 0 : 1;
    }
    memset(a, 0, (size_t)size * sizeof *a);
    for (int i = 0; i < d->count; i++) {
        if (!d->passes[i].over) {
            int over = arcs[d->passes[i].mate], leaving = arcs[i] + 1;
            add_to(&a[row][over < size ? over : 0], 2);
            add_to(&a[row][arcs[i]], PRIME - 1);
            add_to(&a[row][leaving < size ? leaving : 0], PRIME - 1);
            row++;
        }
    }
    return size - 1;
}

static int64_t determinant(uint32_t (*a)[MAX_LEFT], int size)
{
    uint32_t product = 1;
    for (int k = 0; k < size; k++) {
        int pivot = k;
        while (pivot < size && a[pivot][k] == 0) {
            pivot++;
        }
        if (pivot == size) {
            return 0;
        }
        for (int j = k; j < size && pivot != k; j++) {
            uint32_t value = a[k][j];
            a[k][j] = a[pivot][j];
            a[pivot][j] = value;
        }
        product = times(product, a[k][k]);
        uint32_t by_pivot = inverse(a[k][k]);
        for (int i = k + 1; i < size; i++) {
            uint32_t factor = a[i][k] == 0 ? 0 : PRIME - times(a[i][k], by_pivot);
            for (int j = k + 1; j < size && factor != 0; j++) {
                a[i][j] = (uint32_t)((a[i][j] + (uint64_t)factor * a[k][j]) % PRIME);
            }
        }
    }
    return product < PRIME / 2 ? product : PRIME - product; /* its sign was that of row swaps */
}

/* ---- Vassiliev's invariants: Polyak and Viro's sums over parts of the Gauss diagram */

typedef struct arrow {
    int over, under, sign; /* places of its passes */
} arrow;

static int list_arrows(const diagram *d, arrow *arrows)
{
    int count = 0;
    for (int i = 0; i < d->count; i++) {
        if (d->passes[i].over) {
            arrows[count++] = (arrow){i, d->passes[i].mate, d->passes[i].sign};
        }
    }
    return count;
}

/* From the beginning of the curve: under a, over b, over a, under b. */
static int64_t degree_2(const arrow *arrows, int count)
{
    int64_t sum = 0;
    for (int i = 0; i < count; i++) {
        for (int j = 0; j < count; j++) {
            const arrow *a = &arrows[i], *b = &arrows[j];
            if (a->under < b->over && b->over < a->over && a->over < b->under) {
                sum += a->sign == b->sign ? 1 : -1;
            }
        }
    }
    return sum;
}

/* Where the passes of an arrow are, in steps along the curve from a given pass. */
static arrow seen_from(int from, const arrow *a, int count)
{
    int over = a->over - from, under = a->under - from;
    return (arrow){over < 0 ? over + count : over, under < 0 ? under + count : under, a->sign};
}

/* Round the curve: under a, over b, under c, over a, under b, over c. Each three are met from each of
 * their passes under: three times. */
static int64_t triangles(const arrow *arrows, int count)
{
    int64_t sum = 0;
    for (int i = 0; i < count; i++) {
        arrow a = seen_from(arrows[i].under, &arrows[i], 2 * count);
        for (int j = 0; j < count; j++) {
            arrow b = seen_from(arrows[i].under, &arrows[j], 2 * count);
            bool crossed = j != i && b.over < a.over && a.over < b.under;
            for (int k = 0; k < count && crossed; k++) {
                arrow c = seen_from(arrows[i].under, &arrows[k], 2 * count);
                bool found = b.over < c.under && c.under < a.over && b.under < c.over;
                sum += found ? a.sign * b.sign * c.sign : 0;
            }
        }
    }
    return sum / 3;
}

/* Round the curve: under b, over a, under c, over b, over c, under a. */
static int64_t chains(const arrow *arrows, int count)
{
    int64_t sum = 0;
    for (int i = 0; i < count; i++) {
        arrow b = seen_from(arrows[i].under, &arrows[i], 2 * count);
        for (int j = 0; j < count; j++) {
            arrow a = seen_from(arrows[i].under, &arrows[j], 2 * count);
            bool crossed = j != i && a.over < b.over && b.over < a.under;
            for (int k = 0; k < count && crossed; k++) {
                arrow c = seen_from(arrows[i].under, &arrows[k], 2 * count);
                bool found =
                    a.over < c.under && c.under < b.over && b.over < c.over && c.over < a.under;
                sum += found ? a.sign * b.sign * c.sign : 0;
            }
        }
    }
    return sum;
}

/* False: no invariants of a knot; something went wrong. */
static bool degree_3(const arrow *arrows, int count, int64_t *v3)
{
    int64_t twice = 2 * triangles(arrows, count) + chains(arrows, count);
    *v3 = twice / 2;
    return twice % 2 == 0;
}

/* ---- the whole */

static bool from_projection(work *w, size_t count, uint64_t direction, knot_type *type)
{
    arrow arrows[MAX_LEFT];
    vec3 *turned = w->points + count;
    turn(w->points, count, direction, turned);
    if (!find_crossings(turned, count, &w->found)) {
        return false;
    }
    put_in_order(&w->found, w->map, &w->diagram);
    if (!is_planar(&w->diagram, w->map)) {
        return false;
    }
    reduce(&w->diagram, w->map);
    *type = (knot_type){1, 0, 0};
    if (w->diagram.count == 0) {
        return true;
    }
    if (w->diagram.count > 2 * MAX_LEFT) {
        return false;
    }
    type->determinant = determinant(w->matrix, fill_matrix(&w->diagram, w->map, w->matrix));
    int found = list_arrows(&w->diagram, arrows);
    type->v2 = degree_2(arrows, found);
    return degree_3(arrows, found, &type->v3);
}

bool knot_type_same(knot_type a, knot_type b)
{
    return a.determinant == b.determinant && a.v2 == b.v2 && a.v3 == b.v3;
}

bool knot_type_of(const vec3 *x, size_t n, knot_type *type)
{
    size_t count = n + CLOSING_POINTS;
    work *w = n < 2 ? NULL : calloc(1, sizeof *w + (2 * count + 1) * sizeof w->points[0]);
    *type = (knot_type){0, 0, 0};
    if (w == NULL) {
        return false;
    }
    knot_type seen[2];
    int found = 0;
    bool closed = close_curve(x, n, w->points);
    for (uint64_t k = 0; k < PROJECTIONS && found < 2 && closed; k++) {
        found += from_projection(w, count, k, &seen[found]) ? 1 : 0;
    }
    free(w);
    if (found < 2 || !knot_type_same(seen[0], seen[1])) {
        return false;
    }
    *type = seen[0];
    return true;
}

/* ---- what is expected */

knot_type knot_type_of_throws(uint32_t throws, const int *wraps, const int *signs)
{
    knot_type type = {1, 0, 0};
    for (uint32_t i = 0; i < throws; i++) {
        int k = wraps[i];
        type.determinant *= 2 * k + 1;
        type.v2 += k * (k + 1) / 2;
        type.v3 += signs[i] * k * (k + 1) * (2 * k + 1) / 6;
    }
    return type;
}

knot_type knot_type_of_kind(knot_kind kind, bool mirrored)
{
    static const struct {
        uint32_t throws;
        int wraps[3], signs[3];
    } kinds[KNOT_KINDS] = {
        [KNOT_OVERHAND] = {1, {1}, {1}},
        [KNOT_DOUBLE_OVERHAND] = {1, {2}, {1}},
        [KNOT_SQUARE] = {2, {1, 1}, {1, -1}},
        [KNOT_GRANNY] = {2, {1, 1}, {1, 1}},
        [KNOT_SURGEON] = {2, {2, 1}, {1, -1}},
        [KNOT_FLS] = {3, {2, 1, 1}, {1, -1, 1}},
        [KNOT_HALF_HITCHES] = {2, {1, 1}, {1, 1}},
        [KNOT_REVERSED_HALF_HITCHES] = {2, {1, 1}, {1, -1}},
        [KNOT_THREE_THROWS] = {3, {1, 1, 1}, {1, -1, 1}},
    };
    knot_type type = knot_type_of_throws(kinds[kind].throws, kinds[kind].wraps, kinds[kind].signs);
    type.v3 = mirrored ? -type.v3 : type.v3;
    return type;
}
