/* Sections of lofts: circles and jaws. A visual keeps those that it used last, with all that their
 * rings have in common. */
#include <stddef.h>

#include "base/elementary.h"
#include "base/pi.h"
#include "visual/visual.h"

double vbss_visual_max_chord(double curvature, double tolerance)
{
    return sqrt(8.0 * tolerance / vbss_max(curvature, 1e-12));
}

/* A polygon with n sides deviates from its circle by r (1 - cos(pi / n)) <= r (pi / n)^2 / 2. */
static uint32_t count_sides(const visual_object *v, double radius)
{
    double sides = VBSS_PI * sqrt(0.5 * radius / v->config.tube_tolerance);
    double limited = vbss_min(vbss_max(sides, 6.0), v->config.side_limit);
    return (uint32_t)(limited + 0.999);
}

/* ---- points */

static void set_point(visual_section *s, uint32_t index, double u, double v, double nu, double nv)
{
    s->position[0][index] = u;
    s->position[1][index] = v;
    s->normal[0][index] = nu;
    s->normal[1][index] = nv;
}

/* The surface continues from this point to the next one, unless it is the last of a side. */
static void add_point(visual_section *s, bool joins_next, double perimeter_fraction)
{
    s->perimeter_fraction[s->count] = visual_to_float(perimeter_fraction);
    if (joins_next) {
        s->joints[s->joint_count++] = s->count;
    }
    s->count++;
}

static void make_round(visual_section *s)
{
    for (uint32_t i = 0; i <= s->sides; i++) {
        double fraction = (double)i / (double)s->sides, sine, cosine;
        vbss_sincos(i == s->sides ? 0.0 : 2.0 * VBSS_PI * fraction, &sine, &cosine);
        set_point(s, i, cosine, sine, cosine, sine);
        add_point(s, i < s->sides, fraction); /* the seam has two points */
    }
    s->distinct = s->sides;
}

static void make_jaw(visual_section *s)
{
    set_point(s, 0, -1.0, -1.0, 0.0, -1.0);
    add_point(s, true, 0.0);
    for (uint32_t i = 0; i <= s->sides; i++) {
        double fraction = (double)i / (double)s->sides, sine, cosine;
        vbss_sincos(VBSS_PI * (fraction - 0.5), &sine, &cosine);
        set_point(s, s->count, cosine, sine, cosine, sine);
        add_point(s, true, 0.15 + 0.4 * fraction);
    }
    set_point(s, s->count, -1.0, 1.0, 0.0, 1.0);
    add_point(s, false, 0.7);
    set_point(s, s->count, -1.0, 1.0, -1.0, 0.0);
    add_point(s, true, 0.7);
    set_point(s, s->count, -1.0, -1.0, -1.0, 0.0);
    add_point(s, false, 1.0);
    s->distinct = s->count;
}

/* ---- what all rings have in common */

static void make_strip(visual_section *s)
{
    for (uint32_t i = 0; i < s->joint_count; i++) {
        const uint32_t a = s->joints[i], b = s->count + a;
        uint32_t(*out)[3] = &s->strip[2 * (size_t)i];
        out[0][0] = a;
        out[0][1] = out[1][0] = a + 1;
        out[0][2] = out[1][2] = b;
        out[1][1] = b + 1;
    }
}

static void make_dome(visual_section *s)
{
    const uint32_t rings = s->shape == VISUAL_JAW ? (s->sides + 1) / 2 : (s->sides + 3) / 4;
    s->dome_rings = rings < 2 ? 2 : rings;
    for (uint32_t i = 0; i <= s->dome_rings; i++) {
        vbss_sincos(0.5 * VBSS_PI * ((double)i / (double)s->dome_rings), &s->dome_sine[i],
                    &s->dome_cosine[i]);
    }
}

static const visual_section *find_section(visual_object *v, visual_section_shape shape,
                                          uint32_t sides)
{
    for (uint32_t i = 0; i < VISUAL_SECTIONS; i++) {
        if (v->sections[i].shape == shape && v->sections[i].sides == sides) {
            return &v->sections[i];
        }
    }
    visual_section *s = &v->sections[v->next_section++ % VISUAL_SECTIONS];
    s->shape = shape;
    s->sides = sides;
    s->count = s->joint_count = 0;
    if (shape == VISUAL_JAW) {
        make_jaw(s);
    } else {
        make_round(s);
    }
    make_strip(s);
    make_dome(s);
    return s;
}

const visual_section *vbss_visual_round_section(visual_object *v, double radius)
{
    return find_section(v, VISUAL_ROUND, count_sides(v, radius));
}

const visual_section *vbss_visual_jaw_section(visual_object *v, double radius)
{
    return find_section(v, VISUAL_JAW, (count_sides(v, radius) + 1) / 2);
}
