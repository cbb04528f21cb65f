#include "scenes/held_knot.h"

#include "base/elementary.h"
#include "base/error.h"
#include "base/random.h"
#include "scenes/held_look.h"

const char *const held_knot_ends[] = {"grew", "slipped", "held", "open", "not seated", "stuck"};

#define TWO_PI 6.283185307179586
/* The disturbance: waves of these lengths along the thread, m. In so many steps its lengths come right. */
enum { WAVES = 4, CALMING_STEPS = 20 };
#define SHORTEST 4e-3
#define LONGEST 30e-3
/* s: tying, at most; the hands let up; nobody does anything. */
#define TYING 6.0
#define LETTING_UP 1.0
#define RESTING 0.2
/* The rods take so long to come up to their speed, s. */
#define STARTING 0.05
/* After so many steps that the guard cut short, one after the other, nothing will move any more. */
enum { STUCK_STEPS = 20 };
/* Between the axes of the rods in the beginning, m: what is in one place cannot part. */
#define APART 0.1e-3

/* ---- options */

vbss_result held_knot_init(held_knot_options *options, knot_kind kind, double force,
                           double friction)
{
    *options = (held_knot_options){
        .step = 1e-3, .growth = 1e-3, .most_growth = 1.5e-3, .slip = 3e-3, .limit = 10.0};
    VBSS_TRY(tied_knot_init(&options->tied, kind));
    tied_knot_options *t = &options->tied;
    t->scene.thread_friction = friction;
    t->thread.axial_stiffness = 427.0; /* of silk */
    t->knot.cylinder_radius = 2e-3;
    t->knot.finest = 0.4e-3;
    t->lay.force = force;
    t->pull.force = force;
    return VBSS_OK;
}

void held_knot_vary(held_knot_options *options, uint64_t seed)
{
    vbss_random random;
    vbss_random_seed(&random, seed, 11);
    double force = 0.9 + 0.2 * vbss_random_uniform(&random);
    double speed = 0.9 + 0.2 * vbss_random_uniform(&random);
    contact_pull *pulls[2] = {&options->tied.lay, &options->tied.pull};
    for (int i = 0; i < 2; i++) {
        pulls[i]->force *= force;
        pulls[i]->speed *= speed;
    }
    options->seed = seed;
    options->disturbance = 0.2 * options->tied.thread.radius; /* a tenth of the diameter */
}

/* ---- making */

typedef struct wave {
    vec3 size;
    double number, phase;
} wave;

static void draw_waves(const held_knot_options *o, wave *waves)
{
    vbss_random random;
    vbss_random_seed(&random, o->seed, 12);
    for (int i = 0; i < WAVES; i++) {
        double share = vbss_random_uniform(&random);
        waves[i].number = TWO_PI / (SHORTEST * vbss_exp(share * vbss_log(LONGEST / SHORTEST)));
        waves[i].phase = TWO_PI * vbss_random_uniform(&random);
        vec3 way = vbss_random_direction(&random);
        waves[i].size = vec3_scale(way, o->disturbance * sqrt(2.0 / WAVES));
    }
}

static vbss_result disturb(held_knot *knot)
{
    held_line line;
    vec3 x[KNOT_NODES];
    wave waves[WAVES];
    draw_waves(&knot->options, waves);
    VBSS_TRY(held_look_line(&knot->tied, &line));
    for (uint32_t i = 0; i < line.nodes; i++) {
        x[i] = line.x[i];
        for (int w = 0; w < WAVES; w++) {
            double at = waves[w].number * line.arc[i] + waves[w].phase;
            x[i] = vec3_add_scaled(x[i], vbss_sin(at), waves[w].size);
        }
    }
    return vbss_thread_set_state(knot->tied.thread, &x[0].x, NULL, line.nodes);
}

/* What is stretched by the disturbance goes back without a kick: in so short steps that what is bent, as a loose knot is
 * anyway, goes nowhere. */
#define CALMING 0.1
static vbss_result calm(held_knot *knot)
{
    static const vec3 still[KNOT_NODES];
    for (int i = 0; i < CALMING_STEPS; i++) {
        VBSS_TRY(vbss_scene_step(knot->tied.scene, CALMING * knot->options.step));
        VBSS_TRY(
            vbss_thread_set_state(knot->tied.thread, NULL, &still[0].x, knot->tied.node_count));
    }
    return VBSS_OK;
}

static vbss_result leave_alone(held_knot *knot)
{
    return vbss_scene_step(knot->tied.scene, knot->options.step);
}

vbss_result held_knot_create(vbss_context *context, const held_knot_options *options,
                             held_knot *knot)
{
    *knot = (held_knot){.options = *options};
    VBSS_TRY(tied_knot_create(context, &options->tied, &knot->tied));
    VBSS_TRY(disturb(knot));
    return calm(knot);
}

vbss_result held_knot_destroy(held_knot *knot)
{
    return tied_knot_destroy(&knot->tied);
}

/* ---- looking */

double held_knot_drawn_in(const held_knot_edges *before, const held_knot_edges *after)
{
    return vbss_max(before->tails[0] - after->tails[0], after->tails[1] - before->tails[1]);
}

double held_knot_inside(const held_knot_edges *edges)
{
    return edges->tails[1] - edges->tails[0] - (edges->loop[1] - edges->loop[0]);
}

/* After every step: where the knot is, and whether anything moves. */
static vbss_result look(held_knot *knot, bool *touches)
{
    vbss_scene_statistics s;
    VBSS_TRY(vbss_scene_get_statistics(knot->tied.scene, &s, sizeof s));
    knot->clamped_steps = s.clamped > knot->clamped ? knot->clamped_steps + 1 : 0;
    knot->clamped = s.clamped;
    knot->end = knot->clamped_steps >= STUCK_STEPS ? HELD_KNOT_STUCK : knot->end;
    return held_look(&knot->tied, true, &knot->edges, touches);
}

/* ---- tying */

/* The hands give way until they feel nothing, and are gone; slowly, or what they held would spring open. */
static vbss_result let_up(held_knot *knot, bool *touches)
{
    double force = knot->tied.hands[0].pull.force;
    uint32_t steps = (uint32_t)(LETTING_UP / knot->options.step + 0.5);
    for (uint32_t left = steps; left-- > 0 && knot->end != HELD_KNOT_STUCK;) {
        for (int k = 0; k < 2; k++) {
            knot->tied.hands[k].pull.force = force * left / steps;
        }
        VBSS_TRY(tied_knot_step(&knot->tied, knot->options.step));
        VBSS_TRY(look(knot, touches));
    }
    VBSS_TRY(contact_hand_release(&knot->tied.hands[0]));
    return contact_hand_release(&knot->tied.hands[1]);
}

static vbss_result rest(held_knot *knot, bool *touches)
{
    uint32_t steps = (uint32_t)(RESTING / knot->options.step + 0.5);
    for (uint32_t i = 0; i < steps && knot->end != HELD_KNOT_STUCK; i++) {
        VBSS_TRY(leave_alone(knot));
        VBSS_TRY(look(knot, touches));
    }
    return VBSS_OK;
}

/* Within the cylinder, which is the first rod. */
static vbss_result add_rod(held_knot *knot)
{
    vbss_rigid_config config;
    vbss_capsule c = {.radius = knot->options.tied.knot.cylinder_radius - APART};
    vec3 begin = knot->tied.line.cylinder_begin, end = knot->tied.line.cylinder_end, middle;
    VBSS_TRY(held_look_middle(&knot->tied, &knot->edges, &middle));
    vec3 to_knot = vec3_sub(middle, vec3_scale(vec3_add(begin, end), 0.5));
    knot->way = vec3_unit_or(vec3_make(to_knot.z, 0.0, -to_knot.x), vec3_make(1.0, 0.0, 0.0));
    vec3_store(c.begin, vec3_add_scaled(begin, APART, knot->way));
    vec3_store(c.end, vec3_add_scaled(end, APART, knot->way));
    VBSS_TRY(vbss_rigid_config_init(&config, sizeof config));
    config.capsules = &c;
    config.capsule_count = 1;
    config.friction = knot->options.tied.cylinder_friction;
    knot->rods[0] = knot->tied.cylinder_body;
    return vbss_scene_add_rigid(knot->tied.scene, &config, &knot->rods[1]);
}

vbss_result held_knot_tie(held_knot *knot)
{
    bool touches = false;
    knot->end = HELD_KNOT_NOT_SEATED;
    uint32_t most = (uint32_t)(TYING / knot->options.step + 0.5);
    while (!tied_knot_done(&knot->tied) && knot->tied.steps < most) {
        VBSS_TRY(tied_knot_step(&knot->tied, knot->options.step));
    }
    if (!tied_knot_done(&knot->tied)) {
        return VBSS_OK;
    }
    VBSS_TRY(held_look(&knot->tied, false, &knot->edges, &touches));
    knot->seated = knot->edges;
    knot->end = HELD_KNOT_GREW;
    VBSS_TRY(let_up(knot, &touches));
    VBSS_TRY(rest(knot, &touches));
    knot->resting = knot->edges;
    knot->end = knot->end == HELD_KNOT_GREW && !touches ? HELD_KNOT_OPEN : knot->end;
    return add_rod(knot);
}

/* ---- growing */

/* A perimeter of 2 pi r gains as much as an outline whose rods go asunder by this each. */
static vec3 way_of_rod(const held_knot *knot, int k)
{
    return vec3_scale(knot->way, 0.25 * TWO_PI * (k == 0 ? -knot->grown : knot->grown));
}

static vbss_result move_rods(held_knot *knot)
{
    double h = knot->options.step, time = ++knot->growing_steps * h, target[3];
    knot->grown += h * knot->options.growth * vbss_min(time / STARTING, 1.0);
    for (int k = 0; k < 2; k++) {
        vec3_store(target, way_of_rod(knot, k));
        VBSS_TRY(vbss_scene_move_rigid(knot->tied.scene, knot->rods[k], target, NULL));
    }
    return VBSS_OK;
}

/* Of a knot that has neither held nor slipped so far. */
static held_knot_end end_of(const held_knot *knot)
{
    if (knot->tension >= knot->options.limit) {
        return HELD_KNOT_HELD;
    }
    bool slipped = held_knot_drawn_in(&knot->resting, &knot->edges) >= knot->options.slip;
    return slipped ? HELD_KNOT_SLIPPED : HELD_KNOT_GREW;
}

vbss_result held_knot_grow(held_knot *knot, bool *goes_on)
{
    bool touches = false, undecided = knot->end == HELD_KNOT_GREW;
    bool not_through = TWO_PI * knot->grown < knot->options.slip;
    VBSS_TRY(move_rods(knot));
    VBSS_TRY(leave_alone(knot));
    VBSS_TRY(look(knot, &touches));
    VBSS_TRY(held_look_tension(&knot->tied, &knot->edges, &knot->tension));
    knot->tension = touches ? knot->tension : 0.0;
    knot->holds = undecided ? vbss_max(knot->tension, knot->holds) : knot->holds;
    knot->holds_through =
        not_through ? vbss_max(knot->tension, knot->holds_through) : knot->holds_through;
    undecided = undecided && knot->end == HELD_KNOT_GREW;
    knot->end = !touches ? HELD_KNOT_OPEN : undecided ? end_of(knot) : knot->end;
    *goes_on = touches && knot->end != HELD_KNOT_STUCK && knot->tension < knot->options.limit &&
               knot->grown < knot->options.most_growth &&
               (knot->end == HELD_KNOT_GREW || not_through);
    return VBSS_OK;
}

vbss_result held_knot_run(held_knot *knot)
{
    VBSS_TRY(held_knot_tie(knot));
    bool goes_on = knot->end == HELD_KNOT_GREW;
    while (goes_on) {
        VBSS_TRY(held_knot_grow(knot, &goes_on));
    }
    return VBSS_OK;
}
