#include "scene/hole_life.h"

#include "scene/line_crossing.h"
#include "scene/surface_rig.h"

enum { CELLS = 8, SEGMENTS = 60, PERIOD_OF_THROWS = 20 };
#define SIDE 16e-3
#define HAND_RADIUS 0.3e-3
#define HAND_HALF_LENGTH 1.5e-3
/* From the middle of a hand to its end of the thread, m. */
#define HAND_OFFSET 2e-3
/* Contact is complete beyond these distances from a hole: in contact distances, and in segments. */
#define COMPLETE_IN_DISTANCES 3.0
#define COMPLETE_IN_SEGMENTS 1.0
/* Beyond these a crossing is far from its hole. */
#define FAR_IN_DISTANCES 4.0
#define FAR_IN_SEGMENTS 1.2

typedef struct hand {
    uint32_t tool;
    vec3 place, target;
    double speed;
} hand;

typedef struct life {
    small s;
    vbss_random *random;
    const hole_life_hands *speeds;
    hole_life_result *result;
    surface_sheet sheet;
    bool moves;     /* the surface, in waves */
    double segment; /* m */
    vbss_thread *thread;
    uint32_t suture;
    hand hands[2];
    uint32_t steps_to_targets;
} life;

static double draw(life *l, double low, double high)
{
    return low + (high - low) * vbss_random_uniform(l->random);
}

static vec3 draw_vec3(life *l, double low, double high)
{
    const double x = draw(l, low, high), y = draw(l, low, high), z = draw(l, low, high);
    return vec3_make(x, y, z);
}

/* ---- the scene */

static void add_surface(life *l)
{
    surface_make(&l->sheet, CELLS, SIDE);
    l->sheet.config.thickness = pow(10.0, draw(l, -4.0, -3.0));
    l->sheet.config.friction = draw(l, 0.0, 0.6);
    l->sheet.config.hole_friction = draw(l, 0.0, 0.1);
    l->sheet.config.thread_force = draw(l, 1e-6, 5e-3);
    surface_add(&l->s, &l->sheet);
}

static void add_hand(life *l, int which, vec3 end)
{
    hand *h = &l->hands[which];
    h->place = vec3_add(end, vec3_make(0.0, 0.0, HAND_OFFSET));
    h->target = h->place;
    h->tool = small_stick(&l->s, VBSS_SCENE_RIGID_COUPLED, h->place,
                          vec3_make(0.0, 0.0, HAND_HALF_LENGTH), HAND_RADIUS);
    small_pin(&l->s, l->suture, which == 0 ? 0 : SEGMENTS, h->tool);
}

/* A straight thread through the middle of a triangle at the middle of the sheet. */
static void add_thread(life *l)
{
    const double third = 1.0 / 3.0, weights[3] = {third, third, 1.0 - 2.0 * third};
    const uint32_t triangle = 2 * (CELLS / 2 * CELLS + CELLS / 2);
    const double half = 0.5 * SEGMENTS * l->segment;
    vec3 hole = vec3_zero();
    for (int k = 0; k < 3; k++) {
        const uint32_t corner = l->sheet.triangles[triangle][k];
        hole = vec3_add_scaled(hole, weights[k], vec3_load(l->sheet.x[corner]));
    }
    const vec3 ends[2] = {vec3_add(hole, vec3_make(0.0, half, 0.0)),
                          vec3_sub(hole, vec3_make(0.0, half, 0.0))};
    l->suture = small_thread(&l->s, ends[0], ends[1], SEGMENTS, &l->thread);
    expect_ok(
        vbss_scene_make_hole(l->s.scene, l->suture, half, l->sheet.body, triangle, weights, NULL));
    l->s.rigid.stiffness = 2000.0;
    add_hand(l, 0, ends[0]);
    add_hand(l, 1, ends[1]);
}

static void begin(life *l)
{
    small_begin(&l->s);
    l->s.config.floor = 0;
    l->s.config.contact_capacity = 4096;
    l->s.config.candidate_capacity = 65536;
    l->s.config.mode =
        vbss_random_below(l->random, 4) == 0 ? VBSS_SCENE_MODE_OFFLINE : VBSS_SCENE_MODE_REAL_TIME;
    l->s.thread.radius = draw(l, 0.05e-3, 0.2e-3);
    l->segment = vbss_random_below(l->random, 3) == 0 ? 1e-3 : 0.5e-3;
    l->moves = vbss_random_below(l->random, 2) == 0;
    small_create(&l->s);
    add_surface(l);
    add_thread(l);
}

/* ---- a step */

/* One hand draws the thread through the hole, the other follows: each goes to a random direction on its side of the
 * sheet, and both arrive at the same time. */
static void choose_targets(life *l)
{
    const double length = 0.9 * SEGMENTS * l->segment, share = draw(l, 0.1, 0.9);
    const double speed = l->speeds->speed * draw(l, 0.1, 1.0);
    double farther = 0.0;
    for (int which = 0; which < 2; which++) {
        hand *h = &l->hands[which];
        vec3 direction = draw_vec3(l, -1.0, 1.0);
        direction.y = (which == 0 ? 1.0 : -1.0) * (fabs(direction.y) + 0.05);
        h->target = vec3_scale(vec3_unit_or(direction, vec3_make(1.0, 0.0, 0.0)),
                               length * (which == 0 ? share : 1.0 - share));
        farther = fmax(farther, vec3_distance(h->target, h->place));
    }
    for (int which = 0; which < 2; which++) {
        hand *h = &l->hands[which];
        h->speed = speed * vec3_distance(h->target, h->place) / farther;
    }
    l->steps_to_targets = (uint32_t)(farther / (1e-3 * speed)) + 1;
}

static void move_hand(life *l, int which)
{
    hand *h = &l->hands[which];
    const vec3 rest = vec3_sub(h->target, h->place);
    h->place = vec3_add_scaled(h->place, fmin(1e-3 * h->speed, vec3_norm(rest)),
                               vec3_unit_or(rest, vec3_zero()));
    small_move(&l->s, h->tool, h->place);
}

static void throw_thread(life *l)
{
    double velocities[SEGMENTS + 1][3];
    const vec3 middle = small_node(l->thread, SEGMENTS / 2), turn = draw_vec3(l, -100.0, 100.0);
    const vec3 direction = vec3_unit_or(draw_vec3(l, -1.0, 1.0), vec3_make(1.0, 0.0, 0.0));
    const vec3 velocity = vec3_scale(direction, draw(l, 0.1, l->speeds->thrown));
    for (uint32_t i = 0; i <= SEGMENTS; i++) {
        const vec3 arm = vec3_sub(small_node(l->thread, i), middle);
        vec3_store(velocities[i], vec3_add(velocity, vec3_cross(turn, arm)));
    }
    expect_ok(vbss_thread_set_state(l->thread, NULL, velocities[0], SEGMENTS + 1));
}

static void observe(life *l, const vbss_scene_hole *hole)
{
    const vec3 *x = surface_view(&l->s, &l->sheet, VBSS_SCENE_SURFACE_VIEW_POSITIONS);
    const double contact_distance = l->s.thread.radius + 0.5 * l->sheet.config.thickness;
    const double complete =
        fmax(COMPLETE_IN_DISTANCES * contact_distance, COMPLETE_IN_SEGMENTS * l->segment);
    const double far = fmax(FAR_IN_DISTANCES * contact_distance, FAR_IN_SEGMENTS * l->segment);
    uint32_t crossings = 0;
    double farthest = 0.0;
    for (uint32_t i = 0; i < SEGMENTS; i++) {
        const vec3 from = small_node(l->thread, i), to = small_node(l->thread, i + 1);
        for (uint32_t k = 0; k < l->sheet.config.triangle_count; k++) {
            const uint32_t *n = l->sheet.triangles[k];
            const vec3 corner[3] = {x[n[0]], x[n[1]], x[n[2]]};
            double weights[3];
            if (line_crosses_triangle(from, to, corner, weights)) {
                vec3 point = vec3_scale(corner[0], weights[0]);
                point = vec3_add_scaled(point, weights[1], corner[1]);
                point = vec3_add_scaled(point, weights[2], corner[2]);
                farthest = fmax(farthest, vec3_distance(point, vec3_load(hole->position)));
                crossings++;
            }
        }
    }
    l->result->several += crossings > 1 && farthest > complete;
    l->result->far += farthest > far;
    l->result->farthest = fmax(l->result->farthest, farthest);
}

vbss_result hole_life_run(vbss_random *random, uint32_t steps, const hole_life_hands *hands,
                          hole_life_result *result)
{
    static life l;
    memset(&l, 0, sizeof l);
    l.random = random;
    l.speeds = hands;
    l.result = result;
    begin(&l);
    vbss_result done = VBSS_OK;
    double arc = 0.5 * SEGMENTS * l.segment;
    for (uint32_t i = 0; i < steps && done == VBSS_OK; i++) {
        if (hands->thrown > 0.0 && i % PERIOD_OF_THROWS == 0) {
            throw_thread(&l);
        }
        if (l.steps_to_targets-- == 0) {
            choose_targets(&l);
        }
        move_hand(&l, 0);
        move_hand(&l, 1);
        if (l.moves) {
            surface_wave(&l.sheet, 1e-3 * (i + 1));
            surface_move(&l.s, &l.sheet);
        }
        done = vbss_scene_step(l.s.scene, 1e-3);
        vbss_scene_hole hole;
        if (vbss_scene_get_hole(l.s.scene, 0, &hole, sizeof hole) != VBSS_OK) {
            break;
        }
        observe(&l, &hole);
        result->steps++;
        result->slid += fabs(hole.arc_length - arc);
        arc = hole.arc_length;
    }
    result->clamped += small_statistics(&l.s).clamped;
    small_end(&l.s);
    return done;
}
