/* Whether two features meet at a given time follows from signs of polynomials in time:
 *   - meeting features have their four vertices in a plane (the determinant is zero);
 *   - if three of these do not lie on a line, some projection along an axis keeps all that matters, and
 *     orientations of triples decide in the plane;
 *   - else, if two vertices differ, they differ in some coordinate, whose order decides;
 *   - else all are one point.
 * Between neighbouring roots of these polynomials no sign changes, so neither does the answer. The times
 * at which closed features meet are a closed set: if it is not empty, it holds 0, 1 or one of the roots.
 * So the answer at each of these, worked out at the algebraic number itself, is all that is needed. Unless
 * the determinant is zero for all times, its own roots are enough. */
#include "oracle/oracle.h"

#include <math.h>
#include <stddef.h>

#include "oracle/polynomial.h"

enum { TRIPLES = 4 };

typedef struct features {
    int a_count; /* vertices of a: 2 of an edge, 1 for a point; b has the others */
    polynomial x[4][3];
    /* cross[m][k]: component k of the cross product of the triangle without vertex m, in ascending
     * order: its orientation seen along axis k. */
    polynomial cross[TRIPLES][3];
    polynomial apart[4][4][3]; /* x[j] - x[i]; of i < j */
    polynomial determinant;
} features;

/* ---- from doubles to integers: all times one power of two */

static int lowest_power(const double *values, int count)
{
    int lowest = 2000;
    for (int i = 0; i < count; i++) {
        int power;
        (void)frexp(values[i], &power);
        lowest = values[i] != 0.0 && power - 53 < lowest ? power - 53 : lowest;
    }
    return lowest;
}

static void set_scaled(mpz_t integer, double value, int lowest)
{
    int power;
    double mantissa = frexp(value, &power);
    mpz_set_d(integer, ldexp(mantissa, 53));
    if (value != 0.0) {
        mpz_mul_2exp(integer, integer, (mp_bitcnt_t)(power - 53 - lowest));
    }
}

static void set_positions(features *f, const collision_query *query)
{
    int at_start = lowest_power(query->start, 12), at_end = lowest_power(query->end, 12);
    int lowest = at_start < at_end ? at_start : at_end;
    mpz_t from, to;
    mpz_inits(from, to, NULL);
    for (int i = 0; i < 4; i++) {
        for (int k = 0; k < 3; k++) {
            set_scaled(from, query->start[3 * i + k], lowest);
            set_scaled(to, query->end[3 * i + k], lowest);
            mpz_sub(to, to, from);
            polynomial_set_linear(&f->x[i][k], from, to);
        }
    }
    mpz_clears(from, to, NULL);
}

/* a d - b c */
static void set_minor(polynomial *p, const polynomial *a, const polynomial *b, const polynomial *c,
                      const polynomial *d)
{
    polynomial second;
    polynomial_init(&second);
    polynomial_multiply(p, a, d);
    polynomial_multiply(&second, b, c);
    polynomial_subtract(p, p, &second);
    polynomial_clear(&second);
}

static void set_determinant(features *f)
{
    /* x0 lies at -apart[0][j] from xj; the triangle without it is seen from it. */
    polynomial term;
    polynomial_init(&term);
    for (int k = 0; k < 3; k++) {
        polynomial_multiply(&term, &f->cross[0][k], &f->apart[0][1][k]);
        polynomial_subtract(&f->determinant, &f->determinant, &term);
    }
    polynomial_clear(&term);
}

/* Calls `each` for all polynomials. */
static void for_all(features *f, void (*each)(polynomial *p))
{
    for (int i = 0; i < 4; i++) {
        for (int k = 0; k < 3; k++) {
            each(&f->x[i][k]);
            each(&f->cross[i][k]);
            for (int j = 0; j < 4; j++) {
                each(&f->apart[i][j][k]);
            }
        }
    }
    each(&f->determinant);
}

static void features_init(features *f, const collision_query *query)
{
    for_all(f, polynomial_init);
    f->a_count = query->kind == VBSS_COLLISION_PAIR_EDGE_EDGE ? 2 : 1;
    set_positions(f, query);
    for (int i = 0; i < 4; i++) {
        for (int j = i + 1; j < 4; j++) {
            for (int k = 0; k < 3; k++) {
                polynomial_subtract(&f->apart[i][j][k], &f->x[j][k], &f->x[i][k]);
            }
        }
    }
    for (int m = 0; m < TRIPLES; m++) {
        int i = m == 0 ? 1 : 0, j = m <= 1 ? 2 : 1, l = m <= 2 ? 3 : 2;
        for (int k = 0; k < 3; k++) {
            int u = (k + 1) % 3, v = (k + 2) % 3;
            set_minor(&f->cross[m][k], &f->apart[i][j][u], &f->apart[i][j][v], &f->apart[i][l][u],
                      &f->apart[i][l][v]);
        }
    }
    set_determinant(f);
}

/* ---- at one time */

/* Four points in a plane, not all on a line, seen along an axis that shows it: s[m] is the orientation of
 * the triangle without vertex m. */
static bool planar_features_meet(int a_count, const int s[TRIPLES])
{
    if (a_count == 2) {
        /* Each edge has its ends on both sides of the other's line, or on it. The lines differ: had an
         * edge no length, the third and fourth sign were equal and, off the line, not zero. */
        return s[3] * s[2] <= 0 && s[1] * s[0] <= 0;
    }
    /* The triangle is 1 2 3; with the point for one corner it must not turn the other way. Without area
     * it lies on a line, and the point does not. */
    return s[0] != 0 && s[3] * s[0] >= 0 && s[1] * s[0] >= 0 && -s[2] * s[0] >= 0;
}

static bool meet_at(const features *f, const algebraic *time)
{
    if (polynomial_sign_at(&f->determinant, time) != 0) {
        return false;
    }
    for (int k = 0; k < 3; k++) {
        int s[TRIPLES];
        bool any = false;
        for (int m = 0; m < TRIPLES; m++) {
            s[m] = polynomial_sign_at(&f->cross[m][k], time);
            any = any || s[m] != 0;
        }
        if (any) {
            return planar_features_meet(f->a_count, s);
        }
    }
    for (int k = 0; k < 3; k++) {
        int below = 0, above = 0, pairs = 0; /* of b against a */
        for (int i = 0; i < f->a_count; i++) {
            for (int j = f->a_count; j < 4; j++) {
                int sign = polynomial_sign_at(&f->apart[i][j][k], time);
                below += sign < 0 ? 1 : 0;
                above += sign > 0 ? 1 : 0;
                pairs++;
            }
        }
        if (below + above > 0) {
            return below < pairs && above < pairs;
        }
    }
    return true;
}

/* ---- over time */

/* A time and what to ask there. */
typedef struct question {
    const features *f;
    const polynomial *since, *until, *before; /* not negative, not negative, positive */
} question;

static bool meet_in_time(const algebraic *time, void *user)
{
    const question *q = user;
    return polynomial_sign_at(q->since, time) >= 0 && polynomial_sign_at(q->until, time) >= 0 &&
           polynomial_sign_at(q->before, time) > 0 && meet_at(q->f, time);
}

static bool any_root(const polynomial *p, question *q)
{
    return p->degree >= 0 && polynomial_any_root(p, meet_in_time, q);
}

static bool meet_at_critical_times(const features *f, question *q)
{
    if (f->determinant.degree >= 0) {
        return any_root(&f->determinant, q);
    }
    if (any_root(q->since, q) || any_root(q->until, q)) { /* 0 and 1 */
        return true;
    }
    for (int k = 0; k < 3; k++) {
        for (int m = 0; m < TRIPLES; m++) {
            if (any_root(&f->cross[m][k], q)) {
                return true;
            }
        }
        for (int i = 0; i < f->a_count; i++) {
            for (int j = f->a_count; j < 4; j++) {
                if (any_root(&f->apart[i][j][k], q)) {
                    return true;
                }
            }
        }
    }
    return false;
}

/* p = sign (t - time) */
static void set_difference(polynomial *p, int sign, double time)
{
    int lowest = lowest_power(&time, 1);
    lowest = lowest < 0 ? lowest : 0;
    mpz_t c0, c1;
    mpz_inits(c0, c1, NULL);
    set_scaled(c0, time, lowest);
    mpz_set_ui(c1, 1);
    mpz_mul_2exp(c1, c1, (mp_bitcnt_t)-lowest);
    mpz_mul_si(c0, c0, -sign);
    mpz_mul_si(c1, c1, sign);
    polynomial_set_linear(p, c0, c1);
    mpz_clears(c0, c1, NULL);
}

bool oracle_meets_before(const collision_query *query, double t)
{
    features f;
    polynomial bounds[3];
    features_init(&f, query);
    for (int i = 0; i < 3; i++) {
        polynomial_init(&bounds[i]);
    }
    set_difference(&bounds[0], 1, 0.0);
    set_difference(&bounds[1], -1, 1.0);
    set_difference(&bounds[2], -1, t);
    question q = {&f, &bounds[0], &bounds[1], &bounds[2]};
    bool met = meet_at_critical_times(&f, &q);
    for (int i = 0; i < 3; i++) {
        polynomial_clear(&bounds[i]);
    }
    for_all(&f, polynomial_clear);
    return met;
}

bool oracle_meets(const collision_query *query)
{
    return oracle_meets_before(query, 2.0);
}

bool oracle_meets_at(const collision_query *query, double t)
{
    features f;
    polynomial root_at_t;
    features_init(&f, query);
    polynomial_init(&root_at_t);
    set_difference(&root_at_t, 1, t);
    algebraic time = {.of = &root_at_t, .low.power = 0, .high.power = 0};
    mpz_init_set_d(time.low.number, floor(t) - 1.0);
    mpz_init_set_d(time.high.number, floor(t) + 2.0);
    bool met = meet_at(&f, &time);
    mpz_clears(time.low.number, time.high.number, NULL);
    polynomial_clear(&root_at_t);
    for_all(&f, polynomial_clear);
    return met;
}
