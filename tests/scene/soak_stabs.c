/* A needle that pokes at a drain's wall from anywhere, any way, at 1 mm/s to 2 m/s: a thousand pokes a seed, in scenes of
 * many kinds. Each begins clear of the wall, mostly of a state that was saved, or of what the poke before has left. In every
 * part the needle's axes meet the wall at holes only, decided exactly; after every step as many holes are there as events
 * tell, all is finite and where it can be. */
#include <stdlib.h>

#include "base/rotation.h"
#include "scene/needle_watch.h"
#include "scene/stab_places.h"

/* Who enters aslant, at a cosine down to 0.3, crosses the wall beside the hole: in distances of touching. */
#define ASLANT 4.0
#define SLOWEST 1e-3
#define FASTEST 2.0
/* No needle gets farther from the drain in a poke, m. */
#define FAR 0.2

enum {
    LIVES = 25,
    POKES = 40,
    MIN_STEPS = 4,
    MORE_STEPS = 8,
    LONG = 30,
    RELAX_STEPS = 8,
    PINS = 6
};

typedef enum motion { ALONG, STRAIGHT, OBLIQUE, RANDOM, SPIN, MOTIONS } motion;

typedef struct poke {
    motion how;
    double speed;
    vec3 direction;    /* unit: where it goes; about which it spins */
    bool held;         /* by a hand; or it flies */
    uint32_t on, back; /* steps */
} poke;

typedef struct soak {
    harness_soak *out;
    vbss_random random;
    uint64_t pokes, chained, inside, flying, tries, steps, parts, asked, clamped, paused;
    uint64_t pierced, through, glanced,
        missed; /* pokes: a wall, two walls, none but touched, neither */
    uint64_t entries, exits, passed, lost;
    double deepest, fastest, farthest; /* a crossing from its hole, m */
    bool sound;                        /* the poke before was */
} soak;

static needle_case c;
static needle_watch watch;
static small_state begin_of_life; /* the needle is not in the scene */

static double draw(soak *s, double low, double high)
{
    return low + (high - low) * vbss_random_uniform(&s->random);
}

/* As often in every decade. */
static double draw_log(soak *s, double low, double high)
{
    return low * pow(high / low, vbss_random_uniform(&s->random));
}

static bool chance(soak *s, double probability)
{
    return vbss_random_uniform(&s->random) < probability;
}

/* ---- a life */

static void draw_config(soak *s)
{
    vbss_drain_config *d = &c.d.config;
    c.at_hole = ASLANT;
    c.give = 1.0 / d->hole_stiffness;
    c.d.h = chance(s, 0.2) ? 0.5e-3 : 1e-3;
    c.d.s.config.mode = chance(s, 0.15) ? VBSS_SCENE_MODE_OFFLINE : VBSS_SCENE_MODE_REAL_TIME;
    c.d.s.config.hole_capacity = chance(s, 0.2) ? 1 : NEEDLE_CASE_HOLES;
    d->mesh = chance(s, 0.1) ? VBSS_DRAIN_MESH_225 : VBSS_DRAIN_MESH_137;
    d->thickness = chance(s, 0.2) ? 0.5e-3 : d->thickness;
    if (chance(s, 0.6)) {
        d->puncture_force = draw_log(s, 1e-3, 2.0);
        d->hole_force = fmin(d->hole_force, draw(s, 0.1, 1.0) * d->puncture_force);
    }
    d->tear_stress = chance(s, 0.2) ? 1e3 : d->tear_stress;
    d->friction = draw(s, 0.0, 0.6);
    c.config.friction = draw(s, 0.0, 0.5);
    c.config.radius = chance(s, 0.5) ? c.config.radius : draw(s, 3e-3, 10.5e-3);
    c.config.wire_radius = chance(s, 0.7) ? c.config.wire_radius : 0.2e-3;
    c.config.arc = chance(s, 0.7) ? c.config.arc : draw(s, 0.8, 4.5);
}

/* By nothing but its strip, by the edges of its slit, by any nodes; which may have been pulled. */
static void hold_drain(soak *s)
{
    drain_object *d;
    uint32_t nodes[PINS];
    expect_ok(vbss_drain_open(c.d.drain, &d));
    const uint32_t pins = chance(s, 0.3) ? 0 : 1 + vbss_random_below(&s->random, PINS);
    const bool edges = chance(s, 0.5), pulled = chance(s, 0.5);
    for (uint32_t i = 0; i < pins; i++) {
        nodes[i] = edges && i < 2 ? d->mesh.slit_middle[i]
                                  : vbss_random_below(&s->random, d->mesh.node_count);
        bool taken = d->mesh.rest[nodes[i]].y < 0.0; /* the strip may hold it */
        for (uint32_t k = 0; k < i; k++) {
            taken = taken || nodes[k] == nodes[i];
        }
        if (!taken) {
            (void)drain_case_pin(&c.d, nodes[i]);
        }
    }
    for (uint32_t i = 0; i < c.d.pin_count && pulled; i++) {
        vec3 displacement = vec3_scale(vbss_random_direction(&s->random), draw(s, 0.0, 1.5e-3));
        drain_case_target_pin(&c.d, i, vec3_add(c.d.pins[i].at, displacement));
    }
}

static void begin(soak *s)
{
    needle_case_begin(&c);
    draw_config(s);
    needle_case_make(&c);
    needle_watch_begin(&watch, &c);
    hold_drain(s);
    needle_case_put(&c, vec3_make(0.0, 0.0, 0.1), vec3_make(0.0, 1.0, 0.0),
                    vec3_make(0.0, 0.0, 1.0));
    needle_case_wait(&c, RELAX_STEPS);
    needle_case_take_out(&c);
    begin_of_life = small_save(&c.d.s);
}

static void end(soak *s)
{
    s->parts += watch.parts;
    s->asked += watch.asked;
    s->farthest = fmax(s->farthest, c.farthest);
    free(begin_of_life.bytes);
    needle_case_end(&c);
}

/* ---- a poke */

static poke draw_poke(soak *s)
{
    static const double often[MOTIONS] = {0.35, 0.65, 0.8, 0.9, 1.0};
    double which = draw(s, 0.0, 1.0);
    poke p = {.how = ALONG,
              .speed = draw_log(s, SLOWEST, FASTEST),
              .direction = vbss_random_direction(&s->random),
              .held = chance(s, 0.8),
              .on = MIN_STEPS + vbss_random_below(&s->random, chance(s, 0.1) ? LONG : MORE_STEPS),
              .back = chance(s, 0.4) ? vbss_random_below(&s->random, MORE_STEPS) : 0};
    while (which > often[p.how]) {
        p.how++;
    }
    return p;
}

static void target_at(poke *p, const stab_place *place)
{
    if (p->how == STRAIGHT) {
        p->direction = place->direction;
    } else if (p->how == OBLIQUE) {
        p->direction = vec3_unit_or(vec3_add(place->direction, p->direction), place->direction);
    }
}

/* The needle has the speed of the poke from the first step on. */
static void give_speed(const poke *p, const stab_place *place)
{
    vec3 velocity = vec3_scale(p->direction, p->speed), turning = vec3_zero();
    double rate = p->speed / c.config.radius;
    if (p->how == ALONG) {
        turning = vec3_scale(vec3_unit_or(vec3_cross(place->aside, place->direction), p->direction),
                             rate);
        velocity = vec3_zero();
    } else if (p->how == SPIN) {
        turning = vec3_scale(p->direction, rate);
        pose at = needle_case_pose(c.config.radius, place->tip, place->direction, place->aside);
        velocity = vec3_cross(turning, vec3_sub(at.position, place->tip));
    }
    vec3_store(c.config.velocity, velocity);
    vec3_store(c.config.angular_velocity, turning);
}

static void put(soak *s, const poke *p, const stab_place *place)
{
    static const vbss_rigid_coupling soft = {2000.0, 5.0, 0.5, 5e-3};
    give_speed(p, place);
    needle_case_put(&c, place->tip, place->direction, place->aside);
    if (!p->held) {
        needle_case_let_go(&c);
    } else if (chance(s, 0.5)) {
        vbss_scene_body(small_object(&c.d.s), c.body)->rigid.body.coupling = soft;
    }
    memset(c.counts, 0, sizeof c.counts);
}

/* Where the hand has it after one more step that way, or back. */
static void act(const poke *p, double step)
{
    if (p->how == ALONG) {
        needle_case_turn(&c, step);
    } else if (p->how == SPIN) {
        vec3 tip = pose_apply(c.hand, vec3_make(c.config.radius, 0.0, 0.0));
        quat by = vbss_quat_from_rotation_vector(vec3_scale(p->direction, step / c.config.radius));
        vec3 arm = quat_rotate(by, vec3_sub(c.hand.position, tip));
        c.hand = pose_make(vec3_add(tip, arm), quat_mul(by, c.hand.orientation));
    } else {
        needle_case_shift(&c, vec3_scale(p->direction, step));
    }
}

static bool fine(soak *s, const poke *p, uint32_t holes)
{
    uint32_t in = c.counts[VBSS_SCENE_EVENT_PUNCTURE];
    uint32_t out = c.counts[VBSS_SCENE_EVENT_WITHDRAWN] + c.counts[VBSS_SCENE_EVENT_PASSED];
    vbss_needle_state state = needle_case_state(&c);
    double fastest = drain_case_fastest(&c.d), far = vec3_norm(vec3_load(state.tip));
    bool kept = fastest < 1e3 && far < FAR && drain_case_distance(&c.d) < FAR;
    s->fastest = fmax(s->fastest, fastest);
    if (watch.passed == 0 && c.away == 0 && holes == in - out && kept) {
        return true;
    }
    const passing_feature *f = watch.report.first;
    harness_soak_fail(
        s->out,
        "poke %llu, step %llu, motion %d at %g m/s: %llu passed (%u corners: %zu %zu, %u "
        "corners: %zu %zu), %u crossings away from holes; %u in, %u out, %u holes; tip "
        "%g m, drain %g m/s",
        (unsigned long long)s->pokes, (unsigned long long)s->steps, (int)p->how, p->speed,
        (unsigned long long)watch.passed, f[0].corners, f[0].of, f[0].number, f[1].corners, f[1].of,
        f[1].number, c.away, in, out, holes, far, fastest);
    return false;
}

static bool step(soak *s, const poke *p, bool *touched, uint32_t *max_holes)
{
    vbss_scene_hole holes[NEEDLE_CASE_HOLES];
    needle_case_step(&c);
    vbss_scene_rigid_state state = small_rigid(&c.d.s, c.body);
    uint32_t count = needle_case_holes(&c, holes);
    *touched = *touched || vec3_norm(vec3_load(state.contact_force)) > 0.0;
    *max_holes = count > *max_holes ? count : *max_holes;
    s->steps++;
    return fine(s, p, count);
}

static void add_up(soak *s, const vbss_scene_statistics *before, bool touched, uint32_t max_holes)
{
    vbss_scene_statistics t = small_statistics(&c.d.s);
    uint32_t in = c.counts[VBSS_SCENE_EVENT_PUNCTURE];
    s->clamped += t.clamped - before->clamped;
    s->paused += t.paused - before->paused;
    s->entries += in;
    s->exits += c.counts[VBSS_SCENE_EVENT_WITHDRAWN];
    s->passed += c.counts[VBSS_SCENE_EVENT_PASSED];
    s->lost += c.counts[VBSS_SCENE_EVENT_HOLE_LOST];
    s->pierced += in > 0;
    s->through += max_holes > 1;
    s->glanced += in == 0 && touched;
    s->missed += in == 0 && !touched;
    s->deepest = fmax(s->deepest, t.penetration);
}

static void stab(soak *s)
{
    bool good = true, touched = false;
    uint32_t max_holes = 0;
    if (chance(s, 0.2) && s->sound) {
        s->chained++;
    } else {
        expect_ok(vbss_scene_restore(c.d.s.scene, begin_of_life.bytes, begin_of_life.count));
    }
    poke p = draw_poke(s);
    stab_place place = stab_places_draw(&c, 0.3 * p.on * p.speed * c.d.h, &s->random);
    target_at(&p, &place);
    put(s, &p, &place);
    s->pokes++;
    s->inside += place.inside;
    s->flying += !p.held;
    s->tries += place.tries;
    vbss_scene_statistics before = small_statistics(&c.d.s);
    for (uint32_t i = 0; i < p.on + p.back && good; i++) {
        act(&p, (i < p.on ? 1.0 : -1.0) * p.speed * c.d.h);
        good = step(s, &p, &touched, &max_holes);
    }
    add_up(s, &before, touched, max_holes);
    s->sound = good;
    watch.passed = c.away = 0; /* it is told; what follows is another poke */
    needle_case_take_out(&c);
}

static void run(harness_soak *out)
{
    soak s = {.out = out};
    vbss_random_seed(&s.random, out->seed, 7);
    for (int i = 0; i < LIVES; i++) {
        begin(&s);
        s.sound = true;
        for (int k = 0; k < POKES; k++) {
            stab(&s);
        }
        end(&s);
    }
    const struct {
        const char *name;
        double value;
    } figures[] = {
        {"pokes", (double)s.pokes},     {"chained", (double)s.chained},
        {"inside", (double)s.inside},   {"flying", (double)s.flying},
        {"tries", (double)s.tries},     {"steps", (double)s.steps},
        {"parts", (double)s.parts},     {"asked", (double)s.asked},
        {"clamped", (double)s.clamped}, {"paused", (double)s.paused},
        {"pierced", (double)s.pierced}, {"through", (double)s.through},
        {"glanced", (double)s.glanced}, {"missed", (double)s.missed},
        {"entries", (double)s.entries}, {"exits", (double)s.exits},
        {"passed", (double)s.passed},   {"lost", (double)s.lost},
        {"deepest", s.deepest},         {"fastest", s.fastest},
        {"farthest", s.farthest},
    };
    for (size_t i = 0; i < sizeof figures / sizeof figures[0]; i++) {
        harness_soak_figure(out, figures[i].name, figures[i].value);
    }
}

int main(int argc, char **argv)
{
    return harness_soak_main(argc, argv, run);
}
