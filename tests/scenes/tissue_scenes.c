#include "scenes/tissue_scenes.h"

#include "base/elementary.h"
#include "base/error.h"

const char *const tissue_scene_names[TISSUE_SCENE_KINDS] = {"poked",    "pinched", "shut", "opened",
                                                            "inverted", "lifted",  "laden"};
const uint32_t tissue_scene_steps[TISSUE_SCENE_KINDS] = {2400, 900, 300, 600, 900, 700, 600};

#define PI 3.14159265358979323846
/* How fast hands move, m/s. */
#define SPEED 0.04
/* Where the outer wall of the default drain ends. */
#define TOP 7e-3

/* ---- what there is */

typedef struct tool {
    vec3 begin, end; /* of the axis */
    double radius;
} tool;

/* At the begin nothing touches. No tool: radius 0. */
static const tool tools[TISSUE_SCENE_KINDS][TISSUE_TOOLS] = {
    [TISSUE_SCENE_POKED] = {{{0.0, TOP + 1.75e-3, 0.0}, {0.0, TOP + 20e-3, 0.0}, 1.25e-3}},
    [TISSUE_SCENE_PINCHED] = {{{-25e-3, TOP + 3e-3, 0.0}, {25e-3, TOP + 3e-3, 0.0}, 2.5e-3}},
    [TISSUE_SCENE_OPENED] = {{{0.0, 3.5e-3, -0.4e-3}, {0.0, TOP + 15e-3, -0.4e-3}, 0.5e-3},
                             {{0.0, 3.5e-3, 0.8e-3}, {0.0, TOP + 15e-3, 0.8e-3}, 0.5e-3}},
    [TISSUE_SCENE_INVERTED] = {{{10e-3, TOP + 4.5e-3, 0.0}, {10e-3, TOP + 20e-3, 0.0}, 4e-3}},
    [TISSUE_SCENE_LIFTED] = {{{-25e-3, 0.0, 0.0}, {25e-3, 0.0, 0.0}, 1.5e-3}},
};

vbss_result tissue_scene_configs(tissue_scene_kind kind, vbss_method method,
                                 vbss_scene_config *scene, vbss_drain_config *drain)
{
    VBSS_TRY(vbss_scene_config_init(scene, sizeof *scene));
    VBSS_TRY(vbss_drain_config_init(drain, sizeof *drain));
    scene->method = drain->method = method;
    scene->node_capacity = kind == TISSUE_SCENE_LADEN ? 128 : 0;
    scene->floor = kind == TISSUE_SCENE_LIFTED;
    scene->floor_height = -TOP - 0.5e-3;
    if (kind == TISSUE_SCENE_LIFTED) {
        drain->tear_stress = 2e4;
        drain->gravity[1] = -9.81;
    }
    return VBSS_OK;
}

static vbss_result add_tool(tissue_scene *t, const tool *from, uint32_t *number)
{
    vbss_rigid_config c;
    vbss_capsule capsule = {.radius = from->radius};
    VBSS_TRY(vbss_rigid_config_init(&c, sizeof c));
    vec3_store(capsule.begin, from->begin);
    vec3_store(capsule.end, from->end);
    c.kind = VBSS_RIGID_COUPLED;
    c.capsule_count = 1;
    c.capsules = &capsule;
    return vbss_scene_add_rigid(t->scene, &c, number);
}

double tissue_scene_tool(const tissue_scene *t, int which, vec3 axis[2])
{
    vbss_rigid_state state;
    const tool *own = &tools[t->kind][which];
    if (t->tools[which] == 0 ||
        vbss_scene_get_rigid(t->scene, t->tools[which], &state, sizeof state) != VBSS_OK) {
        return 0.0;
    }
    const double *q = state.orientation;
    pose at = pose_make(vec3_load(state.position), quat_make(q[0], q[1], q[2], q[3]));
    axis[0] = pose_apply(at, own->begin);
    axis[1] = pose_apply(at, own->end);
    return own->radius;
}

/* ---- the thread: straight over the top, its ends beyond both sides */

enum { THREAD_NODES = 97 };
#define THREAD_SEGMENT 0.5e-3
#define WEIGHT 0.2       /* N at either end */
#define LOADED_AFTER 0.1 /* s */

/* Attachments 1 and 2. */
static vbss_result take_end(vbss_thread *thread, uint32_t node)
{
    vbss_thread_attachment a;
    uint32_t id;
    VBSS_TRY(vbss_thread_attachment_init(&a, sizeof a));
    a.kind = VBSS_ATTACHMENT_FORCE;
    a.node = node;
    return vbss_thread_attach(thread, &a, &id);
}

static vbss_result load_ends(vbss_thread *thread, double at)
{
    const double force[3] = {0.0, -WEIGHT * vbss_min(at / LOADED_AFTER, 1.0), 0.0};
    VBSS_TRY(vbss_thread_move(thread, 1, force, NULL));
    return vbss_thread_move(thread, 2, force, NULL);
}

static vbss_result add_thread(vbss_context *context, const vbss_scene_config *scene,
                              tissue_scene *t)
{
    vbss_thread_config c;
    double x[3 * THREAD_NODES];
    VBSS_TRY(vbss_thread_config_init(&c, sizeof c));
    c.method = scene->method;
    c.segment_count = THREAD_NODES - 1;
    c.length = THREAD_SEGMENT * (THREAD_NODES - 1);
    c.positions = x;
    for (int i = 0; i < THREAD_NODES; i++) {
        vec3_store(x + 3 * (size_t)i,
                   vec3_make(8e-3, TOP + 0.3e-3, THREAD_SEGMENT * (i - 0.5 * (THREAD_NODES - 1))));
    }
    VBSS_TRY(vbss_thread_create(context, &c, &t->thread));
    VBSS_TRY(take_end(t->thread, 0));
    VBSS_TRY(take_end(t->thread, THREAD_NODES - 1));
    return vbss_scene_add_thread(t->scene, t->thread, &t->thread_body);
}

/* Attachments 1 and 2: the marks, left and right. */
static vbss_result take_marks(tissue_scene *t)
{
    vbss_drain_places places;
    vbss_view rest;
    VBSS_TRY(vbss_drain_get_places(t->drain, &places, sizeof places));
    VBSS_TRY(vbss_drain_get_view(t->drain, VBSS_DRAIN_REST_POSITIONS, &rest, sizeof rest));
    for (int side = 0; side < 2; side++) {
        vbss_drain_attachment a;
        uint32_t id;
        VBSS_TRY(vbss_drain_attachment_init(&a, sizeof a));
        a.node = places.marks[side];
        vec3_store(a.position, ((const vec3 *)rest.data)[a.node]);
        VBSS_TRY(vbss_drain_attach(t->drain, &a, &id));
    }
    return VBSS_OK;
}

vbss_result tissue_scene_create(vbss_context *context, tissue_scene_kind kind,
                                const vbss_scene_config *scene, const vbss_drain_config *drain,
                                tissue_scene *made)
{
    *made = (tissue_scene){.kind = kind};
    VBSS_TRY(vbss_scene_create(context, scene, &made->scene));
    VBSS_TRY(vbss_drain_create(context, drain, &made->drain));
    VBSS_TRY(vbss_scene_add_drain(made->scene, made->drain, &made->drain_body));
    for (int i = 0; i < TISSUE_TOOLS; i++) {
        if (tools[kind][i].radius > 0.0) {
            VBSS_TRY(add_tool(made, &tools[kind][i], &made->tools[i]));
        }
    }
    if (kind == TISSUE_SCENE_LADEN) {
        VBSS_TRY(add_thread(context, scene, made));
    }
    return kind == TISSUE_SCENE_SHUT ? take_marks(made) : VBSS_OK;
}

/* ---- hands: how far a tool is from where it began */

enum { PUSHED = 400, ROUND = 600 };

/* To a depth at SPEED, kept until the time is over, and back. */
static double plunge(double at, double depth, double until)
{
    return vbss_max(vbss_min(vbss_min(SPEED * at, depth), depth - SPEED * (at - until)), 0.0);
}

static vec3 poke(uint64_t step, double h)
{
    static const vec3 places[] = {
        {0.0, 0.0, 4.2e-3}, {0.3e-3, 0.0, 3.2e-3}, {6e-3, 0.0, 0.4e-3}, {-9e-3, 0.0, -3e-3}};
    uint64_t since = step % ROUND;
    const vec3 place = places[step / ROUND % 4];
    double at = h * (double)since, turn = 2.0 * PI * 3.0 * at;
    double depth = plunge(at, 5.5e-3, h * PUSHED), stirred = 0.25 * depth;
    return vec3_add(place, vec3_make(stirred * vbss_sin(turn), -depth, stirred * vbss_cos(turn)));
}

static vec3 way_of(const tissue_scene *t, int which, uint64_t step, double h)
{
    double at = h * (double)step;
    switch (t->kind) {
    case TISSUE_SCENE_POKED:
        return poke(step, h);
    case TISSUE_SCENE_PINCHED:
        return vec3_make(0.0, -plunge(at, 11.5e-3, 0.5), 0.0);
    case TISSUE_SCENE_OPENED:
        return vec3_make(0.0, 0.0, (which == 0 ? -1.0 : 1.0) * plunge(at, 6e-3, 0.4));
    case TISSUE_SCENE_INVERTED:
        return vec3_make(0.0, -plunge(at, 12e-3, 0.4), 0.0);
    case TISSUE_SCENE_LIFTED:
        return vec3_make(0.0, vbss_min(SPEED * at, 25e-3), 0.0);
    default:
        return vec3_zero();
    }
}

vbss_result tissue_scene_shut(tissue_scene *t, double at)
{
    vbss_drain_places places;
    vbss_view rest;
    double way = vbss_min(SPEED * at, 4e-3);
    VBSS_TRY(vbss_drain_get_places(t->drain, &places, sizeof places));
    VBSS_TRY(vbss_drain_get_view(t->drain, VBSS_DRAIN_REST_POSITIONS, &rest, sizeof rest));
    for (uint32_t side = 0; side < 2; side++) {
        double target[3];
        vec3 to = ((const vec3 *)rest.data)[places.marks[side]];
        to.z += side == 0 ? way : -way;
        vec3_store(target, to);
        VBSS_TRY(vbss_drain_move(t->drain, side + 1, target));
    }
    return VBSS_OK;
}

vbss_result tissue_scene_step(tissue_scene *t, double h)
{
    vbss_scene_statistics statistics;
    VBSS_TRY(vbss_scene_get_statistics(t->scene, &statistics, sizeof statistics));
    uint64_t step = statistics.steps;
    for (int i = 0; i < TISSUE_TOOLS; i++) {
        if (t->tools[i] != 0) {
            double to[3];
            vec3_store(to, way_of(t, i, step, h));
            VBSS_TRY(vbss_scene_move_rigid(t->scene, t->tools[i], to, NULL));
        }
    }
    if (t->kind == TISSUE_SCENE_SHUT) {
        VBSS_TRY(tissue_scene_shut(t, h * (double)(step + 1)));
    }
    if (t->thread != NULL) {
        VBSS_TRY(load_ends(t->thread, h * (double)(step + 1)));
    }
    return vbss_scene_step(t->scene, h);
}
