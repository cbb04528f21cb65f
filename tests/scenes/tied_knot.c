#include "scenes/tied_knot.h"

#include "base/error.h"
#include "scenes/tied_build.h"

/* Of the load, what counts as all of it; of a grip's force, what counts as none. */
#define LOADED 0.98
#define SLACK 0.5
/* m from the middle plane: a grip is at its throw. */
#define NEAR 1.5e-3
/* How far pegs are withdrawn, m, and how fast, m/s. */
#define PEG_AWAY 8e-3
#define PEG_SPEED 0.1

vbss_result tied_knot_init(tied_knot_options *options, knot_kind kind)
{
    *options = (tied_knot_options){.cylinder_friction = 0.15,
                                   .peg_friction = 0.05,
                                   .lay = {0.05, 2.0, 1000.0},
                                   .keep = 0.2,
                                   .pull = {0.05, 2.0, 1000.0},
                                   .slack = 0.01,
                                   .rest = 20};
    VBSS_TRY(vbss_scene_config_init(&options->scene, sizeof options->scene));
    VBSS_TRY(vbss_thread_config_init(&options->thread, sizeof options->thread));
    /* An experiment takes the work it needs, but a knot that is stuck not for ever. */
    options->scene.work_limit = 0;
    options->scene.attempt_limit = 16;
    options->thread.axial_stiffness = 4000.0;
    options->thread.gravity[1] = 0.0;
    knot_shape_init(&options->knot, kind);
    options->knot.cylinder = true;
    options->knot.size = 0.7e-3;
    /* The tails are drawn in while lower throws are laid, some centimetres for the third. */
    options->knot.ratio = 1.02;
    options->knot.length = kind == KNOT_FLS ? 0.2 : 0.15;
    return VBSS_OK;
}

/* ---- looking */

static vec3 node_at(const tied_knot *knot, uint32_t node)
{
    vbss_view view;
    if (vbss_thread_get_view(knot->thread, VBSS_THREAD_POSITIONS, &view, sizeof view) != VBSS_OK) {
        return vec3_zero();
    }
    return ((const vec3 *)view.data)[node];
}

vbss_result tied_knot_hash(const tied_knot *knot, uint64_t *hash)
{
    return vbss_scene_get_hash(knot->scene, hash);
}

uint32_t tied_knot_stage(const tied_knot *knot)
{
    return knot->stage;
}

bool tied_knot_done(const tied_knot *knot)
{
    return knot->stage >= knot->throws;
}

double tied_knot_felt(const tied_knot *knot)
{
    return vbss_min(knot->hands[0].felt, knot->hands[1].felt);
}

/* ---- hands */

static vec3 outward(bool right)
{
    return vec3_make(right ? 1.0 : -1.0, 0.0, 0.0);
}

static vbss_result pull_at(tied_knot *knot, uint32_t node, vec3 force, uint32_t *id)
{
    vbss_thread_attachment a;
    VBSS_TRY(vbss_thread_attachment_init(&a, sizeof a));
    a.kind = VBSS_ATTACHMENT_FORCE;
    a.node = node;
    vec3_store(a.force, force);
    return vbss_thread_attach(knot->thread, &a, id);
}

static vbss_result take_up_slack(tied_knot *knot)
{
    for (int k = 0; k < 2; k++) {
        vec3 force = vec3_scale(outward(k == 1), knot->options.slack);
        VBSS_TRY(pull_at(knot, end_node(knot, k), force, &knot->ends[k]));
    }
    return VBSS_OK;
}

/* The line has slid round the pegs: the node that is furthest out now, between the throw that is to be laid
 * and the one above. */
static uint32_t turn_now(const tied_knot *knot, int k)
{
    uint32_t end = end_node(knot, k), i = knot->nodes[knot->stage - 1][k], best = i;
    double side = knot->peg_homes[k].x > 0.0 ? 1.0 : -1.0, furthest = 0.0;
    while (i != end && side * node_at(knot, i).x <= 0.0) {
        i = next_node(k, i, false);
    }
    for (; i != end && side * node_at(knot, i).x > 0.0; i = next_node(k, i, false)) {
        double out = side * node_at(knot, i).x;
        if (out > furthest) {
            furthest = out;
            best = i;
        }
    }
    return best;
}

static vbss_result take(tied_knot *knot, const contact_pull *pull)
{
    double give = knot->options.thread.axial_stiffness / knot->length;
    bool waits = contact_hand_scene_waits(&knot->options.scene);
    for (int k = 0; k < 2; k++) {
        uint32_t node = knot->nodes[knot->stage][k];
        vec3 way = outward(node_at(knot, node).x > 0.0);
        VBSS_TRY(contact_hand_take(&knot->hands[k], knot->thread, node, way, pull, give, waits));
    }
    return VBSS_OK;
}

/* ---- fingers that keep a throw */

static vbss_result grip(tied_knot *knot, int k, uint32_t node)
{
    vec3 way = outward(node_at(knot, node).x > 0.0);
    knot->grips[k].node = node;
    return pull_at(knot, node, vec3_scale(way, knot->options.keep), &knot->grips[k].id);
}

static vbss_result let_go(tied_knot *knot, int k)
{
    uint32_t id = knot->grips[k].id;
    knot->grips[k].id = 0;
    return id != 0 ? vbss_thread_detach(knot->thread, id) : VBSS_OK;
}

/* Far from its throw a grip lets the line slip, and comes nearer, when the throw's limb is slack; near to it, it
 * stays until it is the next throw that pulls. */
static vbss_result keep(tied_knot *knot, int k)
{
    vbss_view view;
    uint32_t node = knot->grips[k].node;
    VBSS_TRY(vbss_thread_get_view(knot->thread, VBSS_THREAD_TENSIONS, &view, sizeof view));
    const double *tensions = view.data;
    double inward = tensions[k == 0 ? node : node - 1];
    double beyond = tensions[k == 0 ? node - 1 : node];
    bool near = fabs(node_at(knot, node).x) < NEAR;
    bool slips = !near && inward < SLACK * knot->options.keep;
    bool over = near && beyond > knot->options.keep;
    if (slips || over) {
        VBSS_TRY(let_go(knot, k));
    }
    return slips ? grip(knot, k, next_node(k, node, true)) : VBSS_OK;
}

/* ---- tying */

static vbss_result begin_stage(tied_knot *knot)
{
    if (knot->stage + 1 < knot->throws) {
        for (int k = 0; k < 2 && knot->stage > 0; k++) {
            knot->nodes[knot->stage][k] = turn_now(knot, k);
        }
        return take(knot, &knot->options.lay);
    }
    for (int k = 0; k < 2; k++) {
        if (knot->ends[k] != 0) {
            VBSS_TRY(vbss_thread_detach(knot->thread, knot->ends[k]));
            knot->ends[k] = 0;
        }
    }
    return take(knot, &knot->options.pull);
}

static vbss_result end_stage(tied_knot *knot)
{
    knot->stage++;
    knot->rested = 0;
    for (int k = 0; k < 2; k++) {
        VBSS_TRY(let_go(knot, k));
        if (!tied_knot_done(knot)) {
            VBSS_TRY(contact_hand_release(&knot->hands[k]));
            VBSS_TRY(grip(knot, k, knot->hands[k].node));
        }
    }
    return tied_knot_done(knot) ? VBSS_OK : begin_stage(knot);
}

static vbss_result withdraw_pegs(tied_knot *knot, double h)
{
    knot->withdrawn = vbss_min(knot->withdrawn + PEG_SPEED * h, PEG_AWAY);
    for (int k = 0; k < TIED_KNOT_PEGS && knot->peg_radius > 0.0; k++) {
        double target[3];
        vec3_store(target, vec3_add(knot->peg_homes[k], vec3_make(0.0, knot->withdrawn, 0.0)));
        VBSS_TRY(vbss_scene_move_rigid(knot->scene, knot->peg_bodies[k], target, NULL));
    }
    return VBSS_OK;
}

static vbss_result move_hands(tied_knot *knot, double h)
{
    for (int k = 0; k < 2; k++) {
        VBSS_TRY(contact_hand_move(&knot->hands[k], h, vec3_zero()));
        if (knot->grips[k].id != 0) {
            VBSS_TRY(keep(knot, k));
        }
    }
    return knot->stage > 0 ? withdraw_pegs(knot, h) : VBSS_OK;
}

vbss_result tied_knot_step(tied_knot *knot, double h)
{
    VBSS_TRY(move_hands(knot, h));
    VBSS_TRY(vbss_scene_step(knot->scene, h));
    knot->steps++;
    if (tied_knot_done(knot)) {
        return VBSS_OK;
    }
    bool loaded = tied_knot_felt(knot) >= LOADED * knot->hands[0].pull.force;
    knot->rested = loaded ? knot->rested + 1 : 0;
    return knot->rested > knot->options.rest ? end_stage(knot) : VBSS_OK;
}

/* ---- the whole */

vbss_result tied_knot_create(vbss_context *context, const tied_knot_options *options,
                             tied_knot *knot)
{
    *knot = (tied_knot){.options = *options};
    VBSS_TRY(tied_build(context, knot));
    if (knot->throws > 1) {
        VBSS_TRY(take_up_slack(knot));
    }
    return begin_stage(knot);
}

vbss_result tied_knot_destroy(tied_knot *knot)
{
    VBSS_TRY(vbss_scene_destroy(knot->scene));
    return vbss_thread_destroy(knot->thread);
}
