/* Pieces of strands in an SVG: a dark edge, a shade, the colour, a shine, one upon the other. */
#include "pieces.h"
#include "xml.h"

enum { COATS = 4 };
typedef struct coat {
    double half, off; /* of its width, and from the middle towards the light; radii */
    /* Each goes on over the neighbours, farther than the one beneath: so no joint shows. Radii; an
     * edge less than a pixel, for its own joints show too where much of it lies twice. */
    double over;
    double edge; /* wider by so many radii, at most 1.5 pixels */
    painter_colour colour;
} coat;

static void coats_of(painter_colour colour, coat coats[COATS])
{
    const rgb dark = rgb_of(PICTURE_INK), white = {1.0, 1.0, 1.0}, own = rgb_of(colour);
    coats[0] = (coat){1.0, 0.0, 0.3, 0.34, rgb_packed(rgb_mix(own, dark, 0.9))};
    coats[1] = (coat){1.0, 0.0, 0.6, 0.0, rgb_packed(rgb_mix(own, dark, 0.5))};
    coats[2] = (coat){0.75, 0.18, 0.9, 0.0, colour};
    coats[3] = (coat){0.2, 0.42, 1.2, 0.0, rgb_packed(rgb_mix(own, white, 0.22))};
}

enum { WALK = 12, POINTS = 64 };

/* Points of a piece in the picture, with what it goes on with on both sides. */
typedef struct outline {
    double x[POINTS], y[POINTS];
    int count;
    bool begins, ends; /* the strand */
} outline;

static void add_point(const drawing *d, outline *o, vec place)
{
    if (o->count < POINTS && view_project(&d->v, place, &o->x[o->count], &o->y[o->count])) {
        o->count++;
    }
}

static void find_outline(const drawing *d, const piece *part, double over, outline *o)
{
    const shape *first = &d->placed[part->first], *last = &d->placed[part->last];
    vec around[WALK];
    o->count = 0;
    int walked = pieces_walk(d, first, part->t0, -1, over, around, WALK, &o->begins);
    while (walked > 0) {
        add_point(d, o, around[--walked]);
    }
    add_point(d, o, vec_lerp(first->a, first->b, part->t0));
    for (const shape *at = first; at != last; at++) {
        add_point(d, o, at->b);
    }
    add_point(d, o, vec_lerp(last->a, last->b, part->t1));
    walked = pieces_walk(d, last, part->t1, 1, over, around, WALK, &o->ends);
    for (int i = 0; i < walked; i++) {
        add_point(d, o, around[i]);
    }
}

/* Moves points across the line towards the upper left, where the light comes from. */
static void move_to_light(const outline *o, double off, outline *moved)
{
    *moved = *o;
    for (int i = 0; i < o->count; i++) {
        int before = i > 0 ? i - 1 : 0, after = i + 1 < o->count ? i + 1 : i;
        double dx = o->x[after] - o->x[before], dy = o->y[after] - o->y[before];
        double length2 = dx * dx + dy * dy, x = -0.6, y = -0.8;
        double along = length2 > 0.0 ? (x * dx + y * dy) / length2 : 0.0;
        moved->x[i] += off * (x - along * dx);
        moved->y[i] += off * (y - along * dy);
    }
}

static void put_end(const drawing *d, double x, double y, double radius, painter_colour colour)
{
    xml_put(d->to, "<circle");
    xml_attribute(d->to, "cx", x);
    xml_attribute(d->to, "cy", y);
    xml_attribute(d->to, "r", radius);
    xml_colour(d->to, "fill", colour);
    xml_put(d->to, "/>\n");
}

static void put_coat(const drawing *d, const piece *part, double radius, const coat *c)
{
    outline middle, o;
    double half = c->half * radius + fmin(c->edge * radius, 1.5);
    double over = c->edge > 0.0 ? fmin(c->over, 0.75 / radius) : c->over;
    find_outline(d, part, over * d->placed[part->first].radius, &middle);
    if (middle.count == 0) {
        return;
    }
    move_to_light(&middle, c->off * radius, &o);
    if (o.begins) {
        put_end(d, o.x[0], o.y[0], half, c->colour);
    }
    if (o.ends) {
        put_end(d, o.x[o.count - 1], o.y[o.count - 1], half, c->colour);
    }
    xml_put(d->to, "<path d=\"M");
    for (int i = 0; i < o.count; i++) {
        xml_number(d->to, o.x[i]);
        xml_put(d->to, " ");
        xml_number(d->to, o.y[i]);
        xml_put(d->to, i + 1 < o.count ? " " : "\"");
    }
    xml_colour(d->to, "stroke", c->colour);
    xml_attribute(d->to, "stroke-width", 2.0 * half);
    /* Many points close by need no round joins, which would stick out at narrow bends. */
    xml_put(d->to, part->first != part->last ? " stroke-linejoin=\"bevel\"/>\n" : "/>\n");
}

void strokes_put(const drawing *d, const piece *part)
{
    const shape *s = &d->placed[part->first];
    vec middle = vec_lerp(s->a, s->b, 0.5 * (part->t0 + part->t1));
    if (d->v.perspective && middle.z <= d->v.near) {
        return;
    }
    coat coats[COATS];
    coats_of(s->colour, coats);
    for (int i = 0; i < COATS; i++) {
        put_coat(d, part, s->radius * view_scale_at(&d->v, middle.z), &coats[i]);
    }
}
