/* The hard families of capsules (reference: collision.md, section 6). What its table leaves open is chosen
 * here: `a` is the middle of a normal frame (a along `a`, p and w = a x p across), b is centred at the
 * origin where nothing else is said, and ranges are uniform. */
#include "scenes/collision_build.h"

#define THICKNESS COLLISION_THICKNESS
#define HALF 2.5 /* of the length of a capsule's axis */

/* A random frame: edge a lies along `a`. */
typedef struct frame {
    vec3 a, p, w;
} frame;

static frame draw_frame(vbss_random *random)
{
    frame f;
    f.a = vbss_random_direction(random);
    vec3 side = vec3_any_normal(f.a);
    double sine, cosine;
    vbss_sincos(draw_real(random, 0.0, 6.283185307179586), &sine, &cosine);
    f.p = vec3_add_scaled(vec3_scale(side, cosine), sine, vec3_cross(f.a, side));
    f.w = vec3_cross(f.a, f.p);
    return f;
}

static void put_edge(vec3 ends[2], vec3 centre, vec3 direction, double half)
{
    ends[0] = vec3_add_scaled(centre, -half, direction);
    ends[1] = vec3_add_scaled(centre, half, direction);
}

/* a in the frame and at rest, half its length as given. */
static frame draw_resting_a(vbss_random *random, collision_motion *m, double half)
{
    frame f = draw_frame(random);
    put_edge(m->start, vec3_zero(), f.a, half);
    put_edge(m->end, vec3_zero(), f.a, half);
    return f;
}

static void put_b(collision_motion *m, vec3 start_centre, vec3 start_direction, vec3 end_centre,
                  vec3 end_direction)
{
    put_edge(m->start + 2, start_centre, start_direction, HALF);
    put_edge(m->end + 2, end_centre, end_direction, HALF);
}

/* The unit vector at an angle from w towards a. */
static vec3 turned(const frame *f, double angle)
{
    double sine, cosine;
    vbss_sincos(angle, &sine, &cosine);
    return vec3_add_scaled(vec3_scale(f->w, cosine), sine, f->a);
}

/* ---- the families */

/* Everything random, on the scale of the half-length. */
static void draw_scattered(vbss_random *random, collision_motion *m, double half, double box,
                           double wobble, double travel)
{
    draw_resting_a(random, m, half);
    vec3 centre = draw_vec3(random, -box, box);
    vec3 direction = vbss_random_direction(random);
    put_edge(m->start + 2, centre, direction, half);
    vec3 way = vbss_random_direction(random);
    way = vec3_scale(way, draw_real(random, 0.0, travel));
    for (int i = 0; i < 4; i++) {
        m->end[i] = vec3_add(m->start[i], draw_vec3(random, -wobble, wobble));
        if (i >= 2) {
            m->end[i] = vec3_add(m->end[i], way);
        }
    }
}

static void generic_fast(vbss_random *random, collision_motion *m)
{
    draw_scattered(random, m, HALF, 3.0, 1.8, 6.0);
}

/* Edges much shorter than D; their vertices wobble as much for their length as in `generic fast`. */
static void tiny(vbss_random *random, collision_motion *m)
{
    draw_scattered(random, m, 5e-4, 0.6, 3.6e-4, 2.0);
}

/* 200 times `generic fast`, D excepted. */
static void huge(vbss_random *random, collision_motion *m)
{
    draw_scattered(random, m, 500.0, 600.0, 360.0, 1000.0);
}

static void far_origin(vbss_random *random, collision_motion *m)
{
    generic_fast(random, m);
    vec3 offset = vec3_make(1e4, -7e3, 3e3);
    for (int i = 0; i < 4; i++) {
        m->start[i] = vec3_add(m->start[i], offset);
        m->end[i] = vec3_add(m->end[i], offset);
    }
}

static void slow(vbss_random *random, collision_motion *m)
{
    frame f = draw_resting_a(random, m, HALF);
    double gap = THICKNESS * draw_real(random, 0.98, 1.3);
    vec3 direction = turned(&f, draw_real(random, 0.0, 1.0));
    put_edge(m->start + 2, vec3_scale(f.p, gap), direction, HALF);
    for (int i = 0; i < 4; i++) {
        m->end[i] = vec3_add(m->start[i], draw_vec3(random, -0.05, 0.05));
    }
}

static void rotation(vbss_random *random, collision_motion *m)
{
    frame f = draw_resting_a(random, m, HALF);
    double above = draw_real(random, 0.3, 1.5);
    double below = draw_real(random, 0.3, 1.5);
    vec3 shift = vec3_scale(f.a, draw_real(random, -1.0, 1.0));
    double angle = draw_real(random, -1.2, 1.2);
    double turn = draw_real(random, 1.6, 3.0);
    put_b(m, vec3_add_scaled(shift, above, f.p), turned(&f, angle),
          vec3_add_scaled(shift, -below, f.p), turned(&f, angle + turn));
}

/* Where a parallel b starts and ends. */
static void draw_pass(vbss_random *random, const frame *f, vec3 centres[2])
{
    double gap = draw_real(random, 0.3, 2.0);
    double end_gap = -gap * draw_real(random, -0.9, 1.5);
    vec3 shift = vec3_scale(f->a, draw_real(random, -6.0, 6.0));
    centres[0] = vec3_add_scaled(shift, gap, f->p);
    centres[1] = vec3_add_scaled(shift, end_gap, f->p);
}

static void parallel(vbss_random *random, collision_motion *m)
{
    frame f = draw_resting_a(random, m, HALF);
    vec3 centres[2];
    draw_pass(random, &f, centres);
    put_b(m, centres[0], f.a, centres[1], f.a);
}

/* The plane is that of a and the way of b. */
static void near_parallel(vbss_random *random, collision_motion *m)
{
    frame f = draw_resting_a(random, m, HALF);
    vec3 centres[2], directions[2];
    draw_pass(random, &f, centres);
    for (int i = 0; i < 2; i++) {
        directions[i] = vec3_add_scaled(f.a, draw_power_of_ten(random, -12.0, -4.0), f.p);
    }
    uint32_t leaves = vbss_random_below(random, 3); /* at the start, at the end, never */
    if (leaves < 2) {
        directions[leaves] =
            vec3_add_scaled(directions[leaves], draw_power_of_ten(random, -12.0, -4.0), f.w);
    }
    put_b(m, centres[0], directions[0], centres[1], directions[1]);
}

static void collinear(vbss_random *random, collision_motion *m)
{
    frame f = draw_resting_a(random, m, HALF);
    vec3 side = vec3_zero();
    if (draw_chance(random, 0.5)) {
        side = vec3_scale(f.p, draw_real(random, 0.0, 0.5));
    }
    vec3 start = vec3_add_scaled(side, draw_real(random, 5.01, 7.0), f.a);
    vec3 end = vec3_add_scaled(side, draw_real(random, -7.0, 7.0), f.a);
    put_b(m, start, f.a, end, f.a);
}

/* One b in six is aimed at a point of a and goes beyond it, the others go anywhere. */
static void zero_length(vbss_random *random, collision_motion *m)
{
    double a_half = draw_chance(random, 0.3) ? 0.0 : HALF;
    frame f = draw_resting_a(random, m, a_half);
    double b_half = draw_chance(random, 0.5) ? 0.0 : 1e-13;
    vec3 start = draw_vec3(random, -2.0, 2.0);
    vec3 direction = vbss_random_direction(random);
    vec3 end;
    if (draw_chance(random, 1.0 / 6.0)) {
        vec3 target = vec3_scale(f.a, draw_real(random, -a_half, a_half));
        end = vec3_add_scaled(start, draw_real(random, 1.0, 2.0), vec3_sub(target, start));
    } else {
        vec3 way = vbss_random_direction(random);
        end = vec3_add_scaled(start, draw_real(random, 0.0, 5.0), way);
    }
    put_edge(m->start + 2, start, direction, b_half);
    put_edge(m->end + 2, end, direction, b_half);
}

static void end_point_graze(vbss_random *random, collision_motion *m)
{
    frame f = draw_resting_a(random, m, HALF);
    vec3 beyond = vec3_scale(f.a, draw_nearly(random, HALF + THICKNESS));
    double gap = draw_real(random, 0.5, 3.0);
    double end_gap = gap * draw_real(random, 0.9, 1.1);
    put_b(m, vec3_add_scaled(beyond, gap, f.p), f.w, vec3_add_scaled(beyond, -end_gap, f.p), f.w);
}

static vec3 draw_flat(vbss_random *random, double x_low, double x_high, double y_low, double y_high)
{
    double x = draw_real(random, x_low, x_high);
    double y = draw_real(random, y_low, y_high);
    return vec3_make(x, y, 0.0);
}

static void coplanar(vbss_random *random, collision_motion *m)
{
    if (draw_chance(random, 0.5)) {
        for (int i = 0; i < 4; i++) {
            m->start[i] = draw_flat(random, -4.0, 4.0, -4.0, 4.0);
            m->end[i] = draw_flat(random, -4.0, 4.0, -4.0, 4.0);
        }
        return;
    }
    put_edge(m->start, vec3_zero(), vec3_make(1.0, 0.0, 0.0), HALF);
    put_edge(m->end, vec3_zero(), vec3_make(1.0, 0.0, 0.0), HALF);
    m->start[2] = draw_flat(random, -6.0, 6.0, 0.3, 1.5);
    m->start[3] = vec3_add(m->start[2], draw_flat(random, -3.0, 3.0, 0.0, 3.0));
    vec3 way = draw_flat(random, -1.0, 1.0, -4.0, 0.0);
    m->end[2] = vec3_add(m->start[2], way);
    m->end[3] = vec3_add(m->start[3], way);
}

/* b starts as in `rotation`; one of its ends shoots past a, or past where a ends. */
static void far_vertex_pass(vbss_random *random, collision_motion *m)
{
    frame f = draw_resting_a(random, m, HALF);
    double above = draw_real(random, 0.3, 1.5);
    vec3 direction = turned(&f, draw_real(random, -1.2, 1.2));
    put_edge(m->start + 2, vec3_scale(f.p, above), direction, HALF);
    double reach = draw_real(random, 2.0, 8.0);
    double down = reach * draw_real(random, 0.5, 1.0);
    double up = reach * draw_real(random, 0.0, 1.0);
    double along = draw_real(random, -8.0, 8.0);
    uint32_t far_one = vbss_random_below(random, 2);
    for (uint32_t i = 0; i < 2; i++) {
        vec3 moved = vec3_add_scaled(m->start[2 + i], i == far_one ? -down : up, f.p);
        m->end[2 + i] = vec3_add_scaled(moved, along, f.a);
    }
}

static void mid_step_graze(vbss_random *random, collision_motion *m)
{
    frame f = draw_resting_a(random, m, HALF);
    vec3 height = vec3_scale(f.p, THICKNESS * draw_real(random, 0.5, 1.5));
    double from = draw_real(random, 1.0, 4.0);
    double to = -from * draw_real(random, 0.8, 1.2);
    double sine, cosine;
    vbss_sincos(draw_real(random, -0.3, 0.3), &sine, &cosine);
    vec3 direction = vec3_add_scaled(vec3_scale(f.a, cosine), sine, f.w);
    put_b(m, vec3_add_scaled(height, from, f.w), direction, vec3_add_scaled(height, to, f.w),
          direction);
}

/* ---- the sets */

static const collision_draw families[] = {
    generic_fast,    slow,     rotation, parallel, near_parallel, collinear,       zero_length,
    end_point_graze, coplanar, tiny,     huge,     far_origin,    far_vertex_pass, mid_step_graze};
const char *const collision_family_names[] = {
    "generic fast", "slow, 1 kHz", "rotation",        "parallel",      "near-parallel",
    "collinear",    "zero length", "end-point graze", "coplanar",      "tiny",
    "huge",         "far origin",  "far-vertex pass", "mid-step graze"};
const uint32_t collision_family_count = sizeof families / sizeof families[0];
_Static_assert(sizeof families / sizeof families[0] ==
                   sizeof collision_family_names / sizeof collision_family_names[0],
               "a name for each");

bool collision_set_family(uint32_t family, uint32_t count, uint64_t seed, collision_set *set)
{
    return collision_set_make(set, collision_family_names[family], count, VBSS_PAIR_EDGE_EDGE,
                              families[family], seed, 100 + family);
}
