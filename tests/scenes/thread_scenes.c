#include "scenes/thread_scenes.h"

#include "base/elementary.h"
#include "base/error.h"
#include "base/hash.h"
#include "base/linear.h"
#include "base/random.h"
#include "base/stream.h"

/* Ids in the order of creation. */
enum { LEFT_HAND = 1, RIGHT_HAND, LEFT_SPRING, RIGHT_SPRING, WEIGHT, PULL, FIRST_PIN };
/* In every period a pin holds the middle for half the time. */
enum { WAY_STEPS = 50, PIN_PERIOD = 32, PIN_COMES = 8, PIN_GOES = 24 };

static const vec3 hand_centres[2] = {{0.0, 0.0, 0.0}, {0.1, 0.0, 0.0}};

vbss_result thread_scene_config(thread_scene_kind kind, vbss_thread_config *config)
{
    VBSS_TRY(vbss_thread_config_init(config, sizeof *config));
    config->segment_count = 24;
    if (kind != THREAD_SCENE_RELEASE) {
        config->drag = 1.0;
        config->damping = 5.0;
        config->rest_curvature = 20.0;
    }
    if (kind == THREAD_SCENE_CUT) {
        config->bending = VBSS_BENDING_LOCAL;
        config->cut_capacity = 8;
    }
    return VBSS_OK;
}

/* ---- what is attached */

static vbss_result attach(vbss_thread *thread, vbss_thread_attachment a, vec3 position)
{
    uint32_t id;
    vec3_store(a.position, position);
    return vbss_thread_attach(thread, &a, &id);
}

static vbss_result attach_all(vbss_thread *thread, const vbss_thread_config *config)
{
    uint32_t n = config->segment_count;
    double l = config->length / n;
    vbss_thread_attachment plain;
    VBSS_TRY(vbss_thread_attachment_init(&plain, sizeof plain));
    vbss_thread_attachment a = plain;
    a.kind = VBSS_ATTACHMENT_CLAMP;
    VBSS_TRY(attach(thread, a, hand_centres[0]));
    a.kind = VBSS_ATTACHMENT_PIN;
    a.node = n;
    VBSS_TRY(attach(thread, a, hand_centres[1]));
    a.kind = VBSS_ATTACHMENT_SPRING;
    a.stiffness = 2.0;
    a.damping = 0.01;
    a.node = n / 4;
    VBSS_TRY(attach(thread, a, vec3_make(l * a.node, 0.01, 0.0)));
    a.node = 2 * n / 3;
    VBSS_TRY(attach(thread, a, vec3_make(l * a.node, 0.0, 0.01)));
    a = plain;
    a.kind = VBSS_ATTACHMENT_MASS;
    a.node = n / 3;
    a.mass = 1e-4;
    VBSS_TRY(attach(thread, a, vec3_zero()));
    a.kind = VBSS_ATTACHMENT_FORCE;
    a.node = n / 2;
    a.force[2] = 1e-3;
    return attach(thread, a, vec3_zero());
}

vbss_result thread_scene_create(vbss_context *context, thread_scene_kind kind,
                                const vbss_thread_config *config, thread_scene *scene)
{
    *scene = (thread_scene){.kind = kind};
    VBSS_TRY(vbss_thread_create(context, config, &scene->thread));
    if (kind != THREAD_SCENE_RELEASE) {
        return attach_all(scene->thread, config);
    }
    vbss_thread_attachment clamp;
    VBSS_TRY(vbss_thread_attachment_init(&clamp, sizeof clamp));
    clamp.kind = VBSS_ATTACHMENT_CLAMP;
    return attach(scene->thread, clamp, vec3_zero());
}

/* ---- how the hands move */

static vec3 waypoint(uint64_t hand, uint64_t number)
{
    vbss_random random;
    vbss_random_seed(&random, 2017 + hand, number);
    vec3 from_centre = vbss_random_direction(&random);
    return vec3_add_scaled(hand_centres[hand], 0.02, from_centre);
}

static vec3 hand_position(uint64_t hand, uint64_t step)
{
    double s = (double)(step % WAY_STEPS) / WAY_STEPS;
    uint64_t way = step / WAY_STEPS;
    return vec3_lerp(waypoint(hand, way), waypoint(hand, way + 1), s * s * (3.0 - 2.0 * s));
}

static vbss_result move_left(vbss_thread *thread, uint64_t step)
{
    double target[3], direction[3];
    double angle = 0.02 * (double)step;
    vec3_store(target, hand_position(0, step));
    vec3_store(direction, vec3_make(1.0, 0.3 * vbss_sin(angle), 0.3 * vbss_cos(angle)));
    return vbss_thread_move(thread, LEFT_HAND, target, direction);
}

static vbss_result move_right(vbss_thread *thread, uint64_t step)
{
    double target[3];
    vec3 hand = hand_position(1, step);
    vec3_store(target, hand);
    VBSS_TRY(vbss_thread_move(thread, RIGHT_HAND, target, NULL));
    vec3_store(target, vec3_add(hand, vec3_make(-0.03, 0.01, 0.0)));
    return vbss_thread_move(thread, RIGHT_SPRING, target, NULL);
}

/* The pin takes the node next to the middle where it is. */
static vbss_result pin_the_middle(vbss_thread *thread, uint32_t node)
{
    vbss_view view;
    vbss_thread_attachment pin;
    VBSS_TRY(vbss_thread_get_view(thread, VBSS_THREAD_POSITIONS, &view, sizeof view));
    VBSS_TRY(vbss_thread_attachment_init(&pin, sizeof pin));
    pin.node = node;
    return attach(thread, pin, ((const vec3 *)view.data)[node]);
}

static vbss_result use_pin(vbss_thread *thread, uint64_t step)
{
    vbss_thread_reaction pull;
    VBSS_TRY(vbss_thread_get_reaction(thread, PULL, &pull, sizeof pull));
    if (step % PIN_PERIOD == PIN_COMES) {
        return pin_the_middle(thread, pull.node - 1);
    }
    if (step % PIN_PERIOD == PIN_GOES) {
        return vbss_thread_detach(thread, FIRST_PIN + (uint32_t)(step / PIN_PERIOD));
    }
    return VBSS_OK;
}

/* ---- the scene */

static vbss_result cut(thread_scene *scene)
{
    vbss_view rest;
    double length = 0.0;
    VBSS_TRY(vbss_thread_get_view(scene->thread, VBSS_THREAD_REST_LENGTHS, &rest, sizeof rest));
    for (uint64_t i = 0; i < rest.count; i++) {
        length += ((const double *)rest.data)[i];
    }
    return vbss_thread_cut(scene->thread, 0.56 * length, &scene->piece);
}

vbss_result thread_scene_step(thread_scene *scene, double h)
{
    uint64_t step = scene->steps++;
    bool whole = scene->kind != THREAD_SCENE_CUT || step < THREAD_SCENE_CUT_STEP;
    if (scene->kind == THREAD_SCENE_CUT && step == THREAD_SCENE_CUT_STEP) {
        VBSS_TRY(cut(scene));
    }
    vbss_thread *right = whole ? scene->thread : scene->piece;
    if (scene->kind != THREAD_SCENE_RELEASE) {
        VBSS_TRY(move_left(scene->thread, step));
        VBSS_TRY(use_pin(scene->thread, step));
    }
    if (scene->kind != THREAD_SCENE_RELEASE && right != NULL) {
        VBSS_TRY(move_right(right, step));
    }
    VBSS_TRY(vbss_thread_step(scene->thread, h));
    return scene->piece != NULL ? vbss_thread_step(scene->piece, h) : VBSS_OK;
}

vbss_result thread_scene_hash(const thread_scene *scene, uint64_t *hash)
{
    uint64_t hashes[2] = {0, 0};
    vbss_stream stream;
    VBSS_TRY(vbss_thread_get_hash(scene->thread, &hashes[0]));
    if (scene->piece != NULL) {
        VBSS_TRY(vbss_thread_get_hash(scene->piece, &hashes[1]));
    }
    vbss_stream_begin_hash(&stream);
    vbss_stream_u64(&stream, 1, hashes, 2);
    *hash = vbss_hash_end(&stream.hash);
    return stream.result;
}
