#include "scenes/swept.h"

/* Sine and cosine of the least angle between an edge and a triangle that meet at a corner, rad. */
#define LEAST_SINE 0.03
#define GREATEST_COSINE 0.9995

/* ---- distances */

static double clamp(double t)
{
    return vbss_min(vbss_max(t, 0.0), 1.0);
}

static double point_segment(vec3 p, vec3 a, vec3 b)
{
    vec3 along = vec3_sub(b, a);
    double d = vec3_norm_squared(along);
    double t = d > 0.0 ? clamp(vec3_dot(vec3_sub(p, a), along) / d) : 0.0;
    return vec3_distance(p, vec3_add_scaled(a, t, along));
}

/* The least of those from the ends, and of the lines where both are nearest inside the segments. */
static double segment_segment(vec3 p, vec3 q, vec3 a, vec3 b)
{
    double least = vbss_min(vbss_min(point_segment(p, a, b), point_segment(q, a, b)),
                            vbss_min(point_segment(a, p, q), point_segment(b, p, q)));
    vec3 u = vec3_sub(q, p), v = vec3_sub(b, a), w = vec3_sub(p, a);
    double uu = vec3_dot(u, u), uv = vec3_dot(u, v), vv = vec3_dot(v, v);
    double uw = vec3_dot(u, w), vw = vec3_dot(v, w), d = uu * vv - uv * uv;
    if (d > 1e-14 * uu * vv) {
        double s = (uv * vw - vv * uw) / d, t = (uu * vw - uv * uw) / d;
        if (s > 0.0 && s < 1.0 && t > 0.0 && t < 1.0) {
            vec3 between = vec3_add_scaled(vec3_add_scaled(w, s, u), -t, v);
            least = vbss_min(least, vec3_norm(between));
        }
    }
    return least;
}

/* Whether the point's foot in the triangle's plane is inside; n: the plane's unit normal. */
static bool foot_inside(vec3 p, const vec3 corners[3], vec3 n)
{
    for (int i = 0; i < 3; i++) {
        vec3 a = corners[i], b = corners[(i + 1) % 3];
        if (vec3_dot(n, vec3_cross(vec3_sub(b, a), vec3_sub(p, a))) < 0.0) {
            return false;
        }
    }
    return true;
}

static double segment_triangle(vec3 p, vec3 q, const vec3 corners[3])
{
    double least = DBL_MAX;
    for (int i = 0; i < 3; i++) {
        least = vbss_min(least, segment_segment(p, q, corners[i], corners[(i + 1) % 3]));
    }
    vec3 normal = vec3_cross(vec3_sub(corners[1], corners[0]), vec3_sub(corners[2], corners[0]));
    double area = vec3_norm(normal);
    if (!(area > 1e-20)) {
        return least; /* thinner than any margin: its edges are all of it */
    }
    vec3 n = vec3_scale(normal, 1.0 / area);
    double at_p = vec3_dot(n, vec3_sub(p, corners[0])), at_q = vec3_dot(n, vec3_sub(q, corners[0]));
    least = foot_inside(p, corners, n) ? vbss_min(least, fabs(at_p)) : least;
    least = foot_inside(q, corners, n) ? vbss_min(least, fabs(at_q)) : least;
    if ((at_p < 0.0) != (at_q < 0.0) &&
        foot_inside(vec3_lerp(p, q, at_p / (at_p - at_q)), corners, n)) {
        return 0.0;
    }
    return least;
}

/* Whether an edge from the corner `at` to p leaves the triangle with corners b and c there at once. */
static bool leaves(vec3 at, vec3 p, vec3 b, vec3 c)
{
    vec3 u = vec3_unit_or(vec3_sub(p, at), vec3_zero());
    vec3 e = vec3_unit_or(vec3_sub(b, at), vec3_zero());
    vec3 f = vec3_unit_or(vec3_sub(c, at), vec3_zero());
    if (vbss_max(vec3_dot(u, e), vec3_dot(u, f)) > GREATEST_COSINE) {
        return false;
    }
    vec3 normal = vec3_cross(e, f);
    double sine = vec3_norm(normal);
    if (!(sine > 1e-9)) {
        return vec3_dot(e, f) > 0.0;
    }
    vec3 n = vec3_scale(normal, 1.0 / sine);
    bool between = vec3_dot(n, vec3_cross(e, u)) >= 0.0 && vec3_dot(n, vec3_cross(u, f)) >= 0.0;
    return !between || fabs(vec3_dot(n, u)) > LEAST_SINE;
}

/* ---- the line */

void swept_begin(swept_line *line, double margin)
{
    line->slots = line->count = line->ray_count = 0;
    line->margin = margin;
}

bool swept_put(swept_line *line, vec3 x, double deviation, bool stays)
{
    uint32_t i = line->slots;
    if (i + 1 >= SWEPT_POINTS) { /* one is spare, for moves */
        return false;
    }
    line->x[i] = x;
    line->deviation[i] = deviation;
    line->stays[i] = stays;
    line->next[i] = i + 1;
    line->previous[i] = i - 1; /* that of the first is never read */
    line->last = i;
    line->slots = line->count = i + 1;
    return true;
}

static vec3 lower(vec3 a, vec3 b)
{
    return vec3_make(vbss_min(a.x, b.x), vbss_min(a.y, b.y), vbss_min(a.z, b.z));
}

static vec3 higher(vec3 a, vec3 b)
{
    return vec3_make(vbss_max(a.x, b.x), vbss_max(a.y, b.y), vbss_max(a.z, b.z));
}

static bool is_left(const swept_line *line, uint32_t i)
{
    return i == 0 ? line->count > 0 : line->next[line->previous[i]] == i;
}

static void box_block(swept_line *line, uint32_t block)
{
    vec3 low = vec3_make(DBL_MAX, DBL_MAX, DBL_MAX), high = vec3_neg(low);
    for (uint32_t i = block * SWEPT_BLOCK; i < (block + 1) * SWEPT_BLOCK && i < line->slots; i++) {
        if (i != line->last && is_left(line, i)) {
            vec3 a = line->x[i], b = line->x[line->next[i]];
            low = lower(low, lower(a, b));
            high = higher(high, higher(a, b));
        }
    }
    line->low[block] = low;
    line->high[block] = high;
}

void swept_finish(swept_line *line)
{
    line->stays[0] = line->stays[line->last] = true;
    for (uint32_t block = 0; block * SWEPT_BLOCK < line->slots; block++) {
        box_block(line, block);
    }
}

void swept_put_ray(swept_line *line, uint32_t vertex, vec3 direction)
{
    line->stays[vertex] = true;
    line->rays[line->ray_count++] =
        (swept_ray){vertex, vec3_add_scaled(line->x[vertex], SWEPT_RAY, direction)};
}

static bool apart(vec3 low_a, vec3 high_a, vec3 low_b, vec3 high_b, double by)
{
    return low_a.x > high_b.x + by || low_b.x > high_a.x + by || low_a.y > high_b.y + by ||
           low_b.y > high_a.y + by || low_a.z > high_b.z + by || low_b.z > high_a.z + by;
}

/* ---- triangles that are free */

/* The triangle of a, v, b: a and b are vertices, v may be one between them; an edge between a and b or their edges
 * to v are sides of it. */
typedef struct sweep {
    const swept_line *line;
    uint32_t a, v, b;
    vec3 corners[3]; /* of a, v, b */
    vec3 low, high;
} sweep;

/* An edge with one end at a vertex of the triangle, the other at p. */
static bool corner_is_free(const sweep *s, uint32_t vertex, vec3 p)
{
    const vec3 *c = s->corners;
    if (vertex == s->a) {
        return leaves(c[0], p, c[1], c[2]);
    }
    return vertex == s->b ? leaves(c[2], p, c[0], c[1]) : leaves(c[1], p, c[2], c[0]);
}

static bool edge_is_free(const sweep *s, uint32_t i)
{
    const swept_line *line = s->line;
    uint32_t j = line->next[i];
    bool from = i == s->a || i == s->v || i == s->b, to = j == s->a || j == s->v || j == s->b;
    if (from && to) {
        return true; /* a side */
    }
    if (from || to) {
        return corner_is_free(s, from ? i : j, line->x[from ? j : i]);
    }
    vec3 p = line->x[i], q = line->x[j];
    return apart(lower(p, q), higher(p, q), s->low, s->high, line->margin) ||
           segment_triangle(p, q, s->corners) > line->margin;
}

static bool is_free(const swept_line *line, uint32_t a, uint32_t v, uint32_t b)
{
    sweep s = {
        .line = line, .a = a, .v = v, .b = b, .corners = {line->x[a], line->x[v], line->x[b]}};
    s.low = lower(s.corners[0], lower(s.corners[1], s.corners[2]));
    s.high = higher(s.corners[0], higher(s.corners[1], s.corners[2]));
    for (uint32_t k = 0; k < line->ray_count; k++) {
        const swept_ray *ray = &line->rays[k];
        bool meets = ray->vertex == a || ray->vertex == v || ray->vertex == b;
        if (meets ? !corner_is_free(&s, ray->vertex, ray->end)
                  : segment_triangle(line->x[ray->vertex], ray->end, s.corners) <= line->margin) {
            return false;
        }
    }
    for (uint32_t block = 0; block * SWEPT_BLOCK < line->slots; block++) {
        if (apart(line->low[block], line->high[block], s.low, s.high, line->margin)) {
            continue;
        }
        for (uint32_t i = block * SWEPT_BLOCK; i < (block + 1) * SWEPT_BLOCK && i < line->slots;
             i++) {
            if (i != line->last && is_left(line, i) && !edge_is_free(&s, i)) {
                return false;
            }
        }
    }
    return true;
}

/* ---- moves */

static void unlink_vertex(swept_line *line, uint32_t v)
{
    uint32_t a = line->previous[v], b = line->next[v];
    line->next[a] = b;
    line->previous[b] = a;
    line->count--;
    box_block(line, a / SWEPT_BLOCK);
    box_block(line, v / SWEPT_BLOCK);
}

static void link_after(swept_line *line, uint32_t a, uint32_t v)
{
    uint32_t b = line->next[a];
    line->next[a] = line->previous[b] = v;
    line->previous[v] = a;
    line->next[v] = b;
    line->count++;
    box_block(line, a / SWEPT_BLOCK);
    box_block(line, v / SWEPT_BLOCK);
}

bool swept_split(swept_line *line, uint32_t vertex)
{
    uint32_t spare = line->slots;
    if (spare + 1 >= SWEPT_POINTS) {
        return false;
    }
    line->x[spare] = vec3_lerp(line->x[vertex], line->x[line->next[vertex]], 0.5);
    line->stays[spare] = false;
    line->slots++;
    link_after(line, vertex, spare);
    return true;
}

bool swept_remove(swept_line *line, uint32_t vertex)
{
    if (line->stays[vertex] || !is_free(line, line->previous[vertex], vertex, line->next[vertex])) {
        return false;
    }
    unlink_vertex(line, vertex);
    return true;
}

/* Two sweeps: a new vertex comes out of the edge after the old one, then the old one goes. */
bool swept_move(swept_line *line, uint32_t vertex, vec3 to)
{
    uint32_t spare = line->slots, after = line->next[vertex];
    if (line->stays[vertex]) {
        return false;
    }
    line->x[spare] = to;
    if (!is_free(line, vertex, spare, after)) {
        return false;
    }
    line->slots++;
    line->stays[spare] = false;
    link_after(line, vertex, spare);
    bool gone = is_free(line, line->previous[vertex], vertex, spare);
    unlink_vertex(line, spare);
    line->slots--;
    if (gone) {
        line->x[vertex] = to;
        box_block(line, vertex / SWEPT_BLOCK);
        box_block(line, line->previous[vertex] / SWEPT_BLOCK);
    }
    return gone;
}

/* ---- the curve that the line stands for */

/* Deviations may be twice what was measured. */
static double strays(const swept_line *line, uint32_t i)
{
    return 2.0 * line->deviation[i];
}

static vec3 direction(const swept_line *line, uint32_t i)
{
    return vec3_unit_or(vec3_sub(line->x[i + 1], line->x[i]), vec3_zero());
}

/* Edge i and the next: neither folds back, both are nearly straight. */
static bool corner_is_plain(const swept_line *line, uint32_t i)
{
    double length = vec3_distance(line->x[i], line->x[i + 1]);
    return strays(line, i) < 0.1 * length &&
           (i + 1 == line->last || vec3_dot(direction(line, i), direction(line, i + 1)) > -0.9);
}

static bool ray_is_plain(const swept_line *line, uint32_t k)
{
    const swept_ray *ray = &line->rays[k];
    vec3 begin = line->x[ray->vertex];
    vec3 along = vec3_unit_or(vec3_sub(ray->end, begin), vec3_zero());
    for (uint32_t j = 0; j < k; j++) {
        const swept_ray *other = &line->rays[j];
        if (segment_segment(begin, ray->end, line->x[other->vertex], other->end) <= line->margin) {
            return false;
        }
    }
    for (uint32_t i = 0; i < line->last; i++) {
        bool plain;
        if (i == ray->vertex || i + 1 == ray->vertex) {
            double sense = i == ray->vertex ? 1.0 : -1.0;
            plain = sense * vec3_dot(along, direction(line, i)) < 0.9;
        } else {
            plain = segment_segment(begin, ray->end, line->x[i], line->x[i + 1]) >
                    line->margin + strays(line, i);
        }
        if (!plain) {
            return false;
        }
    }
    return true;
}

/* Edges i to j, few, go so straight on that none can meet another. */
static bool goes_on(const swept_line *line, uint32_t i, uint32_t j)
{
    bool on = j - i <= 6;
    for (uint32_t k = i + 1; k <= j && on; k++) {
        on = vec3_dot(direction(line, i), direction(line, k)) > 0.8;
    }
    return on;
}

static bool blocks_are_apart(const swept_line *line, uint32_t a, uint32_t b)
{
    for (uint32_t i = a * SWEPT_BLOCK; i < (a + 1) * SWEPT_BLOCK && i < line->last; i++) {
        uint32_t from = b * SWEPT_BLOCK > i + 1 ? b * SWEPT_BLOCK : i + 2;
        vec3 p = line->x[i], q = line->x[i + 1];
        for (uint32_t j = from; j < (b + 1) * SWEPT_BLOCK && j < line->last; j++) {
            double least = line->margin + strays(line, i) + strays(line, j);
            vec3 r = line->x[j], s = line->x[j + 1];
            if (!apart(lower(p, q), higher(p, q), lower(r, s), higher(r, s), least) &&
                segment_segment(p, q, r, s) <= least && !goes_on(line, i, j)) {
                return false;
            }
        }
    }
    return true;
}

bool swept_is_true(const swept_line *line)
{
    double most = 0.0;
    for (uint32_t i = 0; i < line->last; i++) {
        most = vbss_max(most, strays(line, i));
        if (!corner_is_plain(line, i)) {
            return false;
        }
    }
    for (uint32_t k = 0; k < line->ray_count; k++) {
        if (!ray_is_plain(line, k)) {
            return false;
        }
    }
    for (uint32_t a = 0; a * SWEPT_BLOCK < line->slots; a++) {
        for (uint32_t b = a; b * SWEPT_BLOCK < line->slots; b++) {
            if (!apart(line->low[a], line->high[a], line->low[b], line->high[b],
                       line->margin + 2.0 * most) &&
                !blocks_are_apart(line, a, b)) {
                return false;
            }
        }
    }
    return true;
}

bool swept_end_is_outermost(const swept_line *line, uint32_t end, vec3 towards)
{
    for (uint32_t i = 0; i != line->last; i = line->next[i]) {
        uint32_t other = end == i ? line->next[i] : i;
        if (vec3_dot(vec3_sub(line->x[other], line->x[end]), towards) >= 0.0) {
            return false;
        }
    }
    return true;
}
