/* Random edits of a scene: good ones, and some that must be refused. */
#include "fuzz/scenes/fuzzed_scene.h"

#include <math.h>

static vbss_thread *thread_of(const fuzz_side *side, uint32_t number)
{
    vbss_thread *thread = NULL;
    (void)vbss_scene_get_thread(side->scene, number, &thread);
    return thread;
}

static double rest_length(fuzz_scene *f, uint32_t number)
{
    vbss_thread *thread = thread_of(&f->sides[0], number);
    vbss_view lengths;
    double sum = 0.0;
    if (vbss_thread_get_view(thread, VBSS_THREAD_VIEW_REST_LENGTHS, &lengths, sizeof lengths) !=
        VBSS_OK) {
        return 0.01;
    }
    for (uint64_t i = 0; i < lengths.count; i++) {
        const char *length = (const char *)lengths.data + i * lengths.stride_bytes;
        sum += *(const double *)(const void *)length;
    }
    return sum;
}

/* ---- threads */

static void cut(fuzz_scene *f)
{
    const uint32_t thread = fuzz_spoil_number(f, fuzz_choose(f, FUZZ_THREAD));
    const double arc = fuzz_spoil(f, fuzz_real(f, -0.02, 1.02) * rest_length(f, thread));
    uint32_t piece[FUZZ_SIDES] = {0, 0};
    fuzz_trace(f, "thread %u at %g", thread, arc);
    FUZZ_CALL(f, vbss_scene_cut_thread(side->scene, thread, arc, &piece[k]));
    if (f->results[0] == VBSS_OK) {
        f->findings->cuts++;
        fuzz_register(f, piece[0], FUZZ_THREAD, (void *[FUZZ_SIDES]){NULL, NULL});
    }
}

static void pin(fuzz_scene *f)
{
    const uint32_t thread = fuzz_spoil_number(f, fuzz_choose(f, FUZZ_THREAD));
    const fuzz_kind kind = FUZZ_PICK(f, FUZZ_NONE, FUZZ_RIGID, FUZZ_NEEDLE, FUZZ_GRASPER);
    const uint32_t body = kind == FUZZ_NONE ? 0 : fuzz_choose(f, kind);
    const uint32_t node = fuzz_spoil_number(f, fuzz_below(f, 8));
    const uint32_t other = fuzz_spoil_number(f, body);
    uint32_t id[FUZZ_SIDES];
    double point[3];
    vec3_store(point, fuzz_point(f));
    const bool has_point = fuzz_chance(f, 0.2);
    point[2] = fuzz_spoil(f, point[2]);
    fuzz_trace(f, "thread %u node %u to body %u at %g %g %g", thread, node, other,
               has_point ? point[0] : (double)NAN, point[1], point[2]);
    FUZZ_CALL(f, vbss_scene_pin_thread(side->scene, thread, node, other, has_point ? point : NULL,
                                       &id[k]));
}

static void unpin(fuzz_scene *f)
{
    const uint32_t id = fuzz_spoil_number(f, fuzz_below(f, 6));
    fuzz_trace(f, "pin %u", id);
    FUZZ_CALL(f, vbss_scene_unpin_thread(side->scene, id));
}

static void attach_to_thread(fuzz_scene *f)
{
    const uint32_t thread = fuzz_spoil_number(f, fuzz_choose(f, FUZZ_THREAD));
    vbss_thread_attachment a;
    uint32_t id[FUZZ_SIDES];
    vbss_thread_attachment_init(&a, sizeof a);
    a.kind = (vbss_thread_attachment_kind)fuzz_below(f, 5);
    a.node = fuzz_spoil_number(f, fuzz_below(f, 8));
    vec3_store(a.position, fuzz_point(f));
    vec3_store(a.direction, fuzz_direction(f));
    vec3_store(a.force, fuzz_vector(f, 1.0));
    a.stiffness = fuzz_spoil(f, fuzz_small(f, 0.0, 100.0));
    a.damping = fuzz_small(f, 0.0, 0.1);
    a.mass = fuzz_small(f, 1e-5, 0.05);
    fuzz_trace(f, "thread %u node %u kind %d", thread, a.node, a.kind);
    FUZZ_CALL(f, vbss_thread_attach(thread_of(side, thread), &a, &id[k]));
}

static void move_attachment(fuzz_scene *f)
{
    const uint32_t thread = fuzz_spoil_number(f, fuzz_choose(f, FUZZ_THREAD));
    const uint32_t id = fuzz_spoil_number(f, 1 + fuzz_below(f, 4));
    double target[3];
    vec3_store(target, fuzz_point(f));
    target[1] = fuzz_spoil(f, target[1]);
    FUZZ_CALL(f, vbss_thread_set_attachment_target(thread_of(side, thread), id, target, NULL));
}

static void detach(fuzz_scene *f)
{
    const uint32_t thread = fuzz_spoil_number(f, fuzz_choose(f, FUZZ_THREAD));
    const uint32_t id = fuzz_spoil_number(f, 1 + fuzz_below(f, 4));
    FUZZ_CALL(f, vbss_thread_detach(thread_of(side, thread), id));
}

/* ---- drains */

static void edit_drain(fuzz_scene *f)
{
    const uint32_t drain = fuzz_choose(f, FUZZ_DRAIN);
    vbss_drain_attachment a;
    uint32_t id[FUZZ_SIDES];
    if (drain == 0) {
        return;
    }
    vbss_drain_attachment_init(&a, sizeof a);
    a.kind = (vbss_drain_attachment_kind)fuzz_below(f, 3);
    a.node = fuzz_spoil_number(f, fuzz_below(f, 137));
    vec3_store(a.position, fuzz_point(f));
    vec3_store(a.force, fuzz_vector(f, 1.0));
    a.stiffness = fuzz_spoil(f, fuzz_small(f, 0.0, 100.0));
    const uint32_t old = 1 + fuzz_below(f, 3);
    switch (fuzz_below(f, 3)) {
    case 0:
        FUZZ_CALL(f, vbss_drain_attach(side->handles[drain], &a, &id[k]));
        break;
    case 1:
        FUZZ_CALL(f, vbss_drain_set_attachment_target(side->handles[drain], old, a.position));
        break;
    default:
        FUZZ_CALL(f, vbss_drain_detach(side->handles[drain], old));
        break;
    }
}

static void make_hole(fuzz_scene *f)
{
    const uint32_t suture = fuzz_choose(f, fuzz_chance(f, 0.3) ? FUZZ_NEEDLE : FUZZ_THREAD);
    const uint32_t drain = fuzz_spoil_number(f, fuzz_choose(f, FUZZ_DRAIN));
    const uint32_t triangle = fuzz_spoil_number(f, fuzz_below(f, 240));
    const double arc = fuzz_spoil(f, 0.5 * rest_length(f, suture));
    const double u = fuzz_real(f, 0.0, 0.5), v = fuzz_real(f, 0.0, 0.5);
    const double weights[3] = {u, v, fuzz_spoil(f, 1.0 - u - v)};
    uint32_t id[FUZZ_SIDES];
    FUZZ_CALL(f, vbss_scene_make_hole(side->scene, suture, arc, drain, triangle, weights, &id[k]));
}

/* Holes where threads pass through the wall: the triangle is not known, so all are tried. */
static void make_hole_where_possible(fuzz_scene *f)
{
    const uint32_t suture = fuzz_choose(f, FUZZ_THREAD), drain = fuzz_choose(f, FUZZ_DRAIN);
    const double third = 1.0 / 3.0, weights[3] = {third, third, 1.0 - 2.0 * third};
    const double arc = 0.5 * rest_length(f, suture);
    if (drain == 0 || suture == 0) {
        return;
    }
    for (uint32_t i = 0; i < 240 && !f->has_failed; i++) {
        FUZZ_CALL(f, vbss_scene_make_hole(side->scene, suture, arc, drain, i, weights, NULL));
        if (f->results[0] != VBSS_ERROR_OUT_OF_RANGE && f->results[0] != VBSS_ERROR_IN_USE) {
            return;
        }
    }
}

/* ---- tools */

static void set_opening(fuzz_scene *f)
{
    const uint32_t tool = fuzz_choose(f, FUZZ_GRASPER);
    const double opening = fuzz_spoil(f, FUZZ_PICK(f, 0, 0, 0, 1, 2, 5, 10) * 0.1);
    if (tool != 0) {
        FUZZ_CALL(f, vbss_grasper_set_opening(side->handles[tool], opening));
    }
}

static void exchange_tool(fuzz_scene *f)
{
    const uint32_t tool = fuzz_choose(f, FUZZ_GRASPER);
    const vbss_grasper_kind kind = (vbss_grasper_kind)fuzz_spoil_number(f, 1 + fuzz_below(f, 2));
    if (tool != 0) {
        FUZZ_CALL(f, vbss_grasper_exchange(side->handles[tool], kind));
    }
}

/* A tool that is elsewhere in the next step: at a body, or far away. */
static void teleport(fuzz_scene *f)
{
    const uint32_t tool = fuzz_choose(f, fuzz_chance(f, 0.7) ? FUZZ_GRASPER : FUZZ_RIGID);
    const uint32_t body = fuzz_choose(f, fuzz_chance(f, 0.5) ? FUZZ_NEEDLE : FUZZ_THREAD);
    pose at = fuzz_pose(f);
    (void)fuzz_set_target(f, body, &at);
    if (fuzz_chance(f, 0.2)) {
        at.position = fuzz_vector(f, 30.0);
    }
    if (tool == 0 || !f->bodies[tool].has_target) {
        return;
    }
    f->bodies[tool].tip = at.position;
    f->bodies[tool].turn = at.orientation;
    fuzz_move_tool(f, tool);
}

/* ---- bodies */

static void remove_body(fuzz_scene *f)
{
    const fuzz_kind kind =
        FUZZ_PICK(f, FUZZ_THREAD, FUZZ_NEEDLE, FUZZ_GRASPER, FUZZ_RIGID, FUZZ_DRAIN);
    const uint32_t number = fuzz_spoil_number(f, fuzz_choose(f, kind));
    fuzz_trace(f, "body %u", number);
    FUZZ_CALL(f, vbss_scene_remove(side->scene, number));
    if (f->results[0] == VBSS_OK && number < FUZZ_MAX_BODIES) {
        f->bodies[number].is_removed = true;
    }
}

static void add_again(fuzz_scene *f)
{
    for (uint32_t i = 1; i <= f->last_number; i++) {
        fuzz_body *body = &f->bodies[i];
        if (body->is_removed && f->sides[0].handles[i] != NULL && fuzz_chance(f, 0.5)) {
            const uint32_t last = f->last_number;
            fuzz_add_handle(
                f, body->kind,
                f->sides[0].handles[i] == NULL
                    ? NULL
                    : (void *[FUZZ_SIDES]){f->sides[0].handles[i], f->sides[1].handles[i]});
            if (f->last_number > last) {
                body->kind = FUZZ_NONE;
                f->bodies[f->last_number].has_target = body->has_target;
            }
            return;
        }
    }
}

/* What a host may not do with a body of a scene. */
static void treat_as_own(fuzz_scene *f)
{
    const uint32_t thread = fuzz_choose(f, FUZZ_THREAD), needle = fuzz_choose(f, FUZZ_NEEDLE);
    uint32_t number[FUZZ_SIDES];
    if (thread != 0) {
        FUZZ_CALL(f, vbss_thread_step(thread_of(side, thread), 1e-3));
        FUZZ_CALL(f, vbss_thread_destroy(thread_of(side, thread)));
    }
    if (needle != 0) {
        FUZZ_CALL(f, vbss_needle_destroy(side->handles[needle]));
        FUZZ_CALL(f, vbss_scene_add_needle(side->scene, side->handles[needle], &number[k]));
    }
}

void fuzz_edit_at_random(fuzz_scene *f)
{
    static void (*const edits[])(fuzz_scene * f) = {cut,
                                                    cut,
                                                    pin,
                                                    pin,
                                                    unpin,
                                                    attach_to_thread,
                                                    move_attachment,
                                                    detach,
                                                    edit_drain,
                                                    make_hole,
                                                    set_opening,
                                                    set_opening,
                                                    exchange_tool,
                                                    teleport,
                                                    teleport,
                                                    remove_body,
                                                    add_again,
                                                    fuzz_add_random_body,
                                                    fuzz_add_random_body,
                                                    treat_as_own,
                                                    make_hole_where_possible};
    edits[fuzz_below(f, sizeof edits / sizeof edits[0])](f);
}
