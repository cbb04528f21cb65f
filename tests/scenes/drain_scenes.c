#include "scenes/drain_scenes.h"

#include "base/elementary.h"
#include "base/error.h"
#include "base/linear.h"
#include "base/random.h"

const char *const drain_scene_names[DRAIN_SCENE_KINDS] = {"closed", "poked", "tugged"};
const uint32_t drain_scene_steps[DRAIN_SCENE_KINDS] = {200, 1200, 1000};

/* A wall that is pushed in for so long, then left alone. */
enum { PUSHED = 200, LEFT_ALONE = 100 };
/* Of hands that tug: for how long one holds a node, how many there are, and when the block is pulled away from. */
enum { HELD_FOR = 50, HANDS = 3, LIFTED = 700 };
#define PI 3.14159265358979323846

vbss_result drain_scene_config(drain_scene_kind kind, vbss_drain_config *config)
{
    VBSS_TRY(vbss_drain_config_init(config, sizeof *config));
    if (kind == DRAIN_SCENE_TUGGED) {
        config->tear_stress = 3e4; /* it comes off when hands lift it */
        config->gravity[1] = -9.81;
    }
    return VBSS_OK;
}

vbss_result drain_scene_create(vbss_context *context, drain_scene_kind kind,
                               const vbss_drain_config *config, drain_scene *scene)
{
    *scene = (drain_scene){.kind = kind};
    return vbss_drain_create(context, config, &scene->drain);
}

/* ---- hands */

static vec3 rest_of(vbss_drain *drain, uint32_t node)
{
    vbss_view rest;
    return vbss_drain_get_view(drain, VBSS_DRAIN_REST_POSITIONS, &rest, sizeof rest) == VBSS_OK
               ? ((const vec3 *)rest.data)[node]
               : vec3_zero();
}

static vbss_result take(vbss_drain *drain, vbss_drain_attachment_kind kind, uint32_t node)
{
    vbss_drain_attachment a;
    uint32_t id;
    VBSS_TRY(vbss_drain_attachment_init(&a, sizeof a));
    a.kind = kind;
    a.node = node;
    a.stiffness = 200.0;
    vec3_store(a.position, rest_of(drain, node));
    return vbss_drain_attach(drain, &a, &id);
}

static vbss_result move(vbss_drain *drain, uint32_t id, vec3 to)
{
    double target[3];
    vec3_store(target, to);
    return vbss_drain_move(drain, id, target);
}

/* Attachments are named 1, 2, ... as they are made. */
static vbss_result close_slit(vbss_drain *drain, uint64_t step, double h)
{
    const double most = 2.6e-3;
    vbss_drain_places places;
    VBSS_TRY(vbss_drain_get_places(drain, &places, sizeof places));
    double way = vbss_min(DRAIN_SCENE_SPEED * h * (double)(step + 1), most);
    for (uint32_t side = 0; side < 2; side++) {
        if (step == 0) {
            VBSS_TRY(take(drain, VBSS_DRAIN_ATTACHMENT_PIN, places.marks[side]));
        }
        vec3 to = rest_of(drain, places.marks[side]);
        to.z += side == 0 ? way : -way;
        VBSS_TRY(move(drain, side + 1, to));
    }
    return VBSS_OK;
}

static vbss_result poke(vbss_drain *drain, uint64_t step, double h)
{
    vbss_drain_places places;
    VBSS_TRY(vbss_drain_get_places(drain, &places, sizeof places));
    uint64_t round = step / (PUSHED + LEFT_ALONE), since = step % (PUSHED + LEFT_ALONE);
    uint32_t node = round % 2 == 0 ? places.marks[round / 2 % 2] : places.gap_points[round / 2 % 2];
    if (since == 0) {
        VBSS_TRY(take(drain, VBSS_DRAIN_ATTACHMENT_PIN, node));
    }
    if (since == PUSHED) {
        return vbss_drain_detach(drain, (uint32_t)round + 1);
    }
    if (since > PUSHED) {
        return VBSS_OK;
    }
    double depth = vbss_min(DRAIN_SCENE_SPEED * h * (double)(since + 1), 5e-3);
    double turn = 2.0 * PI * 5.0 * h * (double)since, stirred = vbss_min(depth, 1.5e-3);
    vec3 to = rest_of(drain, node);
    to = vec3_add(to, vec3_make(stirred * vbss_sin(turn), -depth, stirred * vbss_cos(turn)));
    return move(drain, (uint32_t)round + 1, to);
}

/* What a hand takes in its turn, and which way it pulls. No two hands take the same node. */
typedef struct grasper_thread_clamp {
    vbss_drain_attachment_kind kind;
    uint32_t node;
    vec3 rest, way; /* way: unit */
} grip;

static vbss_result find_grip(vbss_drain *drain, uint64_t turn, grip *g)
{
    vbss_random random;
    vbss_drain_places places;
    vbss_random_seed(&random, 11, turn);
    VBSS_TRY(vbss_drain_get_places(drain, &places, sizeof places));
    g->kind = (vbss_drain_attachment_kind)vbss_random_below(&random, 3);
    g->way = vbss_random_direction(&random);
    do {
        g->node = vbss_random_below(&random, places.node_count);
        g->rest = rest_of(drain, g->node);
    } while (g->node % HANDS != turn % HANDS || g->rest.y < -4e-3);
    return VBSS_OK;
}

static vbss_result tug_once(vbss_drain *drain, uint64_t turn, uint64_t step)
{
    grip g;
    VBSS_TRY(find_grip(drain, turn, &g));
    uint64_t since = step - turn * HELD_FOR;
    double share = (double)(since + 1) / (HELD_FOR * HANDS);
    double lifted = step > LIFTED ? 0.2e-3 * (double)(step - LIFTED) : 0.0;
    if (since == 0) {
        VBSS_TRY(take(drain, g.kind, g.node));
    }
    bool force = g.kind == VBSS_DRAIN_ATTACHMENT_FORCE;
    vec3 to = vec3_scale(g.way, force ? 0.4 * share : 8e-3 * share);
    to = force ? to : vec3_add(vec3_add(g.rest, to), vec3_make(0.0, lifted, 0.0));
    return move(drain, (uint32_t)turn + 1, to);
}

static vbss_result tug(vbss_drain *drain, uint64_t step)
{
    uint64_t last = step / HELD_FOR, first = last + 1 > HANDS ? last + 1 - HANDS : 0;
    if (step % HELD_FOR == 0 && last >= HANDS) {
        VBSS_TRY(vbss_drain_detach(drain, (uint32_t)(last - HANDS) + 1));
    }
    for (uint64_t turn = first; turn <= last; turn++) {
        VBSS_TRY(tug_once(drain, turn, step));
    }
    return VBSS_OK;
}

vbss_result drain_scene_drive(drain_scene *scene, double h)
{
    vbss_drain_statistics statistics;
    VBSS_TRY(vbss_drain_get_statistics(scene->drain, &statistics, sizeof statistics));
    uint64_t step = statistics.steps;
    return scene->kind == DRAIN_SCENE_CLOSED  ? close_slit(scene->drain, step, h)
           : scene->kind == DRAIN_SCENE_POKED ? poke(scene->drain, step, h)
                                              : tug(scene->drain, step);
}

vbss_result drain_scene_step(drain_scene *scene, double h)
{
    VBSS_TRY(drain_scene_drive(scene, h));
    return vbss_drain_step(scene->drain, h);
}
