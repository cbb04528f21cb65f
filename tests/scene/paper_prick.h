/* What the tests of needles of method VBLAST in walls share: a nearly straight needle that a tool leads along its own way into
 * the side of a drain. */
#ifndef VBSS_TESTS_SCENE_PAPER_PRICK_H
#define VBSS_TESTS_SCENE_PAPER_PRICK_H

#include "base/rotation.h"
#include "baseline/drain.h"
#include "baseline/scene.h"
#include "scene/needles_rig.h"

#define RADIUS 0.3 /* of its arc: 30 mm of it are 0.4 mm from straight */
#define HELD 28e-3
#define START (-1e-3)

typedef struct prick {
    needles_rig r;
    vbss_drain *handle;
    drain_object *drain;
    uint32_t wall, triangle;
    pose first, hold; /* of the needle at START; of the tool to it */
    vec3 into;
    uint32_t in, out, lost; /* events so far */
    double depth;
    vec3 aside;
} prick;

static inline void begin_with(prick *p, const double weights[3], uint32_t hole_capacity)
{
    memset(p, 0, sizeof *p);
    needles_begin(&p->r);
    small *s = &p->r.tools.s;
    s->config.method = p->r.config.method = s->drain.method = VBSS_METHOD_VBLAST;
    s->config.capsule_capacity = 64;
    s->config.hole_capacity = hole_capacity;
    small_create(s);
    p->wall = small_drain(s, &p->handle);
    expect_ok(vbss_drain_open(p->handle, &p->drain));
    /* The triangle whose middle is nearest to the side (+z), half a cell off mid-length. */
    double nearest = 1.0;
    for (uint32_t t = 0; t < p->drain->mesh.triangle_count; t++) {
        const suture_hole middle = {.triangle = t,
                                    .barycentric = {1.0 / 3.0, 1.0 / 3.0, 1.0 / 3.0}};
        vec3 at =
            vbss_drain_point(p->drain, p->drain->mesh.rest, middle.triangle, middle.barycentric);
        double far = vec3_distance(at, vec3_make(-2e-3, 0.3e-3, 6.5e-3));
        p->triangle = far < nearest ? t : p->triangle;
        nearest = vbss_min(far, nearest);
    }
    const suture_hole place = {.triangle = p->triangle,
                               .barycentric = {weights[0], weights[1], weights[2]}};
    vec3 corner[3];
    for (int k = 0; k < 3; k++) {
        corner[k] = p->drain->mesh.rest[p->drain->mesh.triangles[p->triangle][k]];
    }
    p->into = vec3_unit_or(
        vec3_cross(vec3_sub(corner[2], corner[0]), vec3_sub(corner[1], corner[0])), vec3_zero());
    assert_true(p->into.z < -0.9);
    vec3 tip = vec3_add_scaled(
        vbss_drain_point(p->drain, p->drain->mesh.rest, place.triangle, place.barycentric), START,
        p->into);
    quat turn = quat_between(vec3_make(0.0, 1.0, 0.0), p->into);
    p->first = pose_make(vec3_sub(tip, quat_rotate(turn, vec3_make(RADIUS, 0.0, 0.0))), turn);
    p->r.config.radius = RADIUS;
    p->r.config.arc = 0.1;
    pose_store(p->first, p->r.config.position, p->r.config.orientation);
    needles_add(&p->r);
    /* Jaws across it at HELD, the shaft away from the centre of its arc. */
    quat across = vbss_quat_from_rotation_vector(vec3_make(0.0, 1.5707963267948966, 0.0));
    quat round = vbss_quat_from_rotation_vector(vec3_make(0.0, 0.0, -HELD / RADIUS));
    vec3 out = quat_rotate(round, vec3_make(1.0, 0.0, 0.0));
    p->hold = pose_make(vec3_scale(out, RADIUS - 2e-3), quat_mul(round, across));
    p->r.tools.config.jaw_speed = 1e3;
    tools_add(&p->r.tools, vec3_make(0.0, 0.0, 0.5)); /* away from the drain */
    p->depth = START;
}

static const double middle[3] = {1.0 / 3.0, 1.0 / 3.0, 1.0 / 3.0};

/* One step, after which the tip is so far beyond the middle of the wall at rest. */
static inline void go(prick *p, double depth)
{
    vbss_scene_event event;
    double tip[3], turn[4];
    pose needle = p->first;
    needle.position = vec3_add_scaled(needle.position, depth - START, p->into);
    needle.position = vec3_add(needle.position, p->aside);
    pose_store(pose_mul(needle, p->hold), tip, turn);
    expect_ok(vbss_grasper_set_target(p->r.tools.tools[0], tip, turn));
    tools_steps(&p->r.tools, 1);
    p->in += tools_happened(&p->r.tools, VBSS_SCENE_EVENT_PUNCTURE, &event);
    p->out += tools_happened(&p->r.tools, VBSS_SCENE_EVENT_WITHDRAWN, &event);
    p->lost += tools_happened(&p->r.tools, VBSS_SCENE_EVENT_HOLE_LOST, &event);
    p->depth = depth;
}

/* At 50 mm/s. */
static inline void drive(prick *p, double depth)
{
    while (fabs(depth - p->depth) > 1e-9) {
        go(p, p->depth + vbss_max(-5e-5, vbss_min(5e-5, depth - p->depth)));
    }
}

static inline void tremble(prick *p, double about, double by, int steps)
{
    vbss_random random;
    vbss_random_seed(&random, 5, (uint64_t)steps);
    for (int i = 0; i < steps; i++) {
        go(p, about + by * (2.0 * vbss_random_uniform(&random) - 1.0));
    }
}

static inline void begin(prick *p)
{
    begin_with(p, middle, 4);
    go(p, START);
    tools_open(&p->r.tools, 0, 0.0);
    go(p, START);
    assert_int_equal(tools_state(&p->r.tools, 0).needle, p->r.body);
}

static inline uint32_t toggles(const prick *p)
{
    const scene_object *s = small_object(&p->r.tools.s);
    const baseline_body *own = baseline_body_of(s, vbss_scene_body(s, p->r.body));
    uint32_t count = 0;
    for (int i = 0; i < BASELINE_TOGGLES; i++) {
        count += own->toggles[i].drain != 0;
    }
    return count;
}

static inline vbss_scene_hole hole_of(const prick *p, uint32_t index)
{
    vbss_scene_hole hole;
    expect_ok(vbss_scene_get_hole(p->r.tools.s.scene, index, &hole, sizeof hole));
    return hole;
}

static inline double moved_max(const prick *p)
{
    double largest = 0.0;
    for (uint32_t i = 0; i < p->drain->mesh.node_count; i++) {
        largest = vbss_max(largest, vec3_distance(p->drain->x[i], p->drain->baseline->rest[i]));
    }
    return largest;
}

#endif
