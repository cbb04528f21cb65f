#include "throw/scenery.h"

#define FLOOR_HALF 0.16
#define DRAIN_HALF 16e-3
#define ELEVATION 0.2 /* rad, of the front view */
#define EYE_AWAY 0.4
#define BORDER 1.12
#define TAIL_TINT 0.5

#define PI 3.14159265358979324

enum { SIDES = 120, CORNERS = 2 * SIDES + 1 }; /* of the drain, where it is cut */
enum { FLOOR_CELLS = 32, PARTS = 4, MAX_POINTS = PARTS * MAX_THREAD_NODES + 1 };

/* ---- boxes */

scenery_box scenery_nothing(void)
{
    return (scenery_box){v3(1e9, 1e9, 1e9), v3(-1e9, -1e9, -1e9)};
}

void scenery_include(scenery_box *b, vec x, double radius)
{
    b->low = v3(smaller(b->low.x, x.x - radius), smaller(b->low.y, x.y - radius),
                smaller(b->low.z, x.z - radius));
    b->high = v3(larger(b->high.x, x.x + radius), larger(b->high.y, x.y + radius),
                 larger(b->high.z, x.z + radius));
}

static bool is_in(const scenery_box *b, vec x)
{
    return x.x >= b->low.x && x.x <= b->high.x && x.y >= b->low.y && x.y <= b->high.y &&
           x.z >= b->low.z && x.z <= b->high.z;
}

/* ---- what stands there */

bool scenery_add_ground(painter *p)
{
    const double centre[3] = {0.0, 0.0, FLOOR_HEIGHT};
    const double u[3] = {FLOOR_HALF, 0.0, 0.0}, v[3] = {0.0, FLOOR_HALF, 0.0};
    const double begin[3] = {0.0, -DRAIN_HALF, -DRAIN_RADIUS};
    const double end[3] = {0.0, DRAIN_HALF, -DRAIN_RADIUS};
    return painter_add_floor(p, centre, u, v, FLOOR_CELLS, PAINTER_FLOOR) == PAINTER_OK &&
           painter_add_capsule(p, begin, end, DRAIN_RADIUS, PAINTER_TISSUE) == PAINTER_OK;
}

bool scenery_add_half_drain(painter *p, double y)
{
    vec corners[CORNERS]; /* the near ring, the far one, the near middle */
    uint32_t indices[9 * SIDES], count = 0;
    for (uint32_t i = 0; i < SIDES; i++) {
        double angle = 2.0 * PI * i / SIDES;
        double x = DRAIN_RADIUS * vbss_cos(angle), z = DRAIN_RADIUS * (vbss_sin(angle) - 1.0);
        uint32_t next = (i + 1) % SIDES;
        uint32_t three[9] = {i,         next, SIDES + i, next,       SIDES + next,
                             SIDES + i, i,    next,      CORNERS - 1};
        corners[i] = v3(x, y, z);
        corners[i + SIDES] = v3(x, DRAIN_HALF, z);
        for (int k = 0; k < 9; k++) {
            indices[count++] = three[k];
        }
    }
    corners[CORNERS - 1] = v3(0.0, y, -DRAIN_RADIUS);
    return painter_add_triangles(p, &corners[0].x, CORNERS, 0, indices, count / 3,
                                 PAINTER_TISSUE) == PAINTER_OK;
}

static bool add_tool(painter *p, const hand *h)
{
    vbss_view view;
    painter_colour colour = demo_side(h) == 0 ? PAINTER_GREEN : PAINTER_YELLOW;
    bool good = vbss_grasper_get_view(h->grasper, VBSS_GRASPER_VIEW_CAPSULES, &view, sizeof view) ==
                VBSS_OK;
    for (uint64_t i = 0; good && i < view.count; i++) {
        const double *part = (const double *)view.data + 7 * i;
        bool shaft = i == 0;
        good = painter_add_capsule(p, part, part + 3, part[6], shaft ? colour : PAINTER_STEEL) ==
               PAINTER_OK;
    }
    return good;
}

bool scenery_add_tools(painter *p, const senses *s)
{
    return add_tool(p, s->w) && add_tool(p, s->c);
}

/* ---- the thread */

bool scenery_add_thread(painter *p, const senses *s)
{
    static painter_colour colours[MAX_THREAD_NODES];
    for (uint32_t i = 0; i + 1 < s->nodes; i++) {
        colours[i] = i < s->rig->marks[0]   ? SCENERY_TAIL
                     : i < s->rig->marks[1] ? PAINTER_VIOLET
                                            : SCENERY_LIMB;
    }
    return painter_add_chain(p, &throw_rig_nodes(s->rig)[0].x, s->nodes, 0, THREAD_RADIUS,
                             PAINTER_VIOLET, colours) == PAINTER_OK;
}

static painter_colour tinted(painter_colour c, double share)
{
    painter_colour mixed = 0;
    for (int shift = 0; shift <= 16; shift += 8) {
        double part = (double)(c >> shift & 0xffu);
        mixed |= (painter_colour)(part + share * (255.0 - part)) << shift;
    }
    return mixed;
}

/* As in the gallery of knots: the throws as the detector tells them, lighter on the tail. */
painter_colour scenery_throw_colour(uint32_t number, bool tail)
{
    static const painter_colour colours[] = {PAINTER_VERMILION, PAINTER_BLUE, PAINTER_GREEN,
                                             PAINTER_PINK};
    painter_colour c = colours[number % (sizeof colours / sizeof colours[0])];
    return tail ? tinted(c, TAIL_TINT) : c;
}

static painter_colour colour_at(const senses *s, const demo_knot *k, double place)
{
    const uint32_t *marks = s->rig->marks;
    for (uint32_t i = 0; i < k->state.throw_count && i < DEMO_THROWS; i++) {
        const vbss_knot_throw *t = &k->throws[i];
        bool located = (t->flags & VBSS_KNOT_THROW_LOCATED) != 0;
        if (located && place >= t->tail_places[0] && place <= t->tail_places[1]) {
            return scenery_throw_colour(i, true);
        }
        if (located && place >= t->long_places[0] && place <= t->long_places[1]) {
            return scenery_throw_colour(i, false);
        }
    }
    return place < 0.5 * (marks[0] + marks[1]) ? 0xf4f1e8u : 0x5f6973u;
}

/* The cubic through two nodes whose slopes are those of the parabolas through them and their neighbours. */
static vec between(const vec *x, uint32_t nodes, uint32_t i, double t)
{
    vec before = x[i > 0 ? i - 1 : 0], after = x[i + 2 < nodes ? i + 2 : nodes - 1];
    vec begin = v_scale(0.5, v_sub(x[i + 1], before)), end = v_scale(0.5, v_sub(after, x[i]));
    double u = 1.0 - t;
    vec at = v_scale(u * u * (1.0 + 2.0 * t), x[i]);
    at = v_along(at, t * t * (3.0 - 2.0 * t), x[i + 1]);
    return v_along(v_along(at, t * u * u, begin), -t * t * u, end);
}

static bool add_run(painter *p, const senses *s, const demo_knot *k, uint32_t from, uint32_t to)
{
    static vec points[MAX_POINTS];
    static painter_colour colours[MAX_POINTS];
    const vec *x = throw_rig_nodes(s->rig);
    size_t count = 0;
    for (uint32_t i = from; i < to; i++) {
        for (int part = 0; part < PARTS; part++) {
            colours[count] = colour_at(s, k, i + (part + 0.5) / PARTS);
            points[count++] = between(x, s->nodes, i, (double)part / PARTS);
        }
    }
    points[count++] = x[to];
    return painter_add_chain(p, &points[0].x, count, 0, THREAD_RADIUS, PAINTER_VIOLET, colours) ==
           PAINTER_OK;
}

bool scenery_add_knot(painter *p, const senses *s, const demo_knot *k, const scenery_box *b)
{
    const vec *x = throw_rig_nodes(s->rig);
    uint32_t first = 0;
    bool good = true;
    for (uint32_t i = 0; i < s->nodes && good; i++) {
        bool inside = is_in(b, x[i]), last = i + 1 == s->nodes;
        if (inside && !last) {
            continue;
        }
        if (i > first + 1 || (inside && i > first)) { /* with a segment on either side */
            good = add_run(p, s, k, first, i);
        }
        first = i;
    }
    return good;
}

/* ---- from where */

bool scenery_set_view(painter *p, const scenery_box *b, bool above, int width, int height, int top,
                      double min_width)
{
    double angle = above ? 0.5 * PI : ELEVATION;
    vec right = v3(1.0, 0.0, 0.0), up = v3(0.0, vbss_sin(angle), vbss_cos(angle));
    vec back = v3(0.0, -vbss_cos(angle), vbss_sin(angle));
    vec size = v_sub(b->high, b->low), middle = v_mix(b->low, b->high, 0.5);
    double across = v_dot(size, right);
    double tall = fabs(size.y * up.y) + fabs(size.z * up.z);
    double wide = larger(BORDER * larger(across, tall * width / (height - top)), min_width);
    middle = v_along(middle, 0.5 * top * wide / width, up);
    painter_camera c = {.width = wide};
    v_store(c.target, middle);
    v_store(c.eye, v_along(middle, EYE_AWAY, back));
    v_store(c.up, up);
    return painter_set_camera(p, &c) == PAINTER_OK;
}
