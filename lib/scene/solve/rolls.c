/* Rolls of threads with friction torque, as unknowns of the system.
 *
 * A span between two rolls is a spring of stiffness GJ/L in its twist. Its elongation depends on the rolls at its
 * ends and, through the shape, on its nodes. If the system has all of the span's nodes as separators, as in a knot,
 * the spring contains both, and the matrix is exact. Otherwise it contains the rolls alone, and
 * the bound of thread/twist.c stands for the nodes. */
#include "base/error.h"
#include "scene/contacts/contacts.h"
#include "scene/solve/solve.h"
#include "scene/tuning.h"
#include "scene/world/world.h"
#include "thread/twist.h"

uint32_t vbss_scene_count_roll_blocks(const thread_object *t)
{
    return thread_has_friction_torque(t)
               ? (t->node_count - 1 + SCENE_ROLLS_PER_BLOCK - 1) / SCENE_ROLLS_PER_BLOCK
               : 0;
}

static uint32_t roll_block(const scene_thread *b, uint32_t segment)
{
    return scene_first_roll_block(b) + segment / SCENE_ROLLS_PER_BLOCK;
}

vbss_result vbss_scene_register_rolls(scene_object *s, const scene_thread *b)
{
    const thread_object *t = b->thread;
    const uint32_t count = vbss_scene_count_roll_blocks(t);
    uint32_t first;
    if (count == 0) {
        return VBSS_OK;
    }
    VBSS_TRY(vbss_system_add_chain(s->system, count, &first));
    for (uint32_t i = 0; i < count; i++) {
        vbss_system_set_role(s->system, first + i, VBSS_ROLE_PRESCRIBED);
    }
    for (uint32_t i = 0; i + 1 < t->node_count; i++) {
        if (t->has_roll[i] != 0) {
            vbss_system_set_role(s->system, roll_block(b, i), VBSS_ROLE_SEPARATOR);
        }
    }
    return VBSS_OK;
}

/* ---- springs */

static bool has_roll(const thread_twist_span *span)
{
    return span->roll_segment[0] != THREAD_NO_ROLL || span->roll_segment[1] != THREAD_NO_ROLL;
}

/* Whether the separators' system has all nodes of a span, and no body eliminates one of them. */
static bool is_exact(const scene_object *s, const scene_thread *b, const thread_twist_span *span)
{
    if (span->high - span->low + 1 > THREAD_EXACT_SPAN_NODES) {
        return false;
    }
    for (uint32_t i = span->low; i <= span->high; i++) {
        const bool is_separator = s->step.is_separator[b->first_node + i] != 0;
        if (b->thread->welded[i] != 0 || (!is_separator && b->thread->prescribed_by[i] == 0)) {
            return false;
        }
    }
    return true;
}

/* Rolls at both ends may share a block. */
static void add_roll(contact_spring *spring, const scene_thread *b, uint32_t segment, double sign)
{
    const uint32_t number = roll_block(b, segment), component = segment % SCENE_ROLLS_PER_BLOCK;
    const double gradient = sign / b->thread->config.radius;
    uint32_t k = 0;
    while (k < spring->count && spring->blocks[k] != number) {
        k++;
    }
    if (k == spring->count) {
        spring->blocks[k] = number;
        spring->gradients[k] = vec3_zero();
        spring->count++;
    }
    vec3 *g = &spring->gradients[k];
    *(component == 0 ? &g->x : component == 1 ? &g->y : &g->z) = gradient;
}

static void set_spring(contact_spring *spring, const scene_thread *b, uint32_t k)
{
    const thread_object *t = b->thread;
    const thread_twist_span *span = &t->twist_spans[k];
    spring->count = 0;
    spring->stiffness = t->config.torsional_stiffness / span->length;
    for (int end = 0; end < 2; end++) {
        if (span->roll_segment[end] != THREAD_NO_ROLL) {
            add_roll(spring, b, span->roll_segment[end], end == 0 ? -1.0 : 1.0);
        }
    }
    for (uint32_t i = span->low; t->is_span_exact[k] != 0 && i <= span->high; i++) {
        spring->blocks[spring->count] = b->first_block + i;
        spring->gradients[spring->count++] = t->span_gradients[k][i - span->low];
    }
}

static void mark_exact_spans(const scene_object *s, const scene_thread *b)
{
    thread_object *t = b->thread;
    for (uint32_t k = 0; k < t->twist_span_count; k++) {
        t->is_span_exact[k] = has_roll(&t->twist_spans[k]) && is_exact(s, b, &t->twist_spans[k]);
    }
}

/* The thread of a body, if it has rolls in the substep; or NULL. */
static scene_thread *find_rolling_thread(scene_body *b)
{
    const bool is_rolling = scene_active_kind(b) == SCENE_BODY_THREAD &&
                            thread_has_friction_torque(b->thread.thread) &&
                            b->thread.thread->roll_count > 0;
    return is_rolling ? &b->thread : NULL;
}

void vbss_scene_mark_exact_spans(scene_object *s)
{
    for (uint32_t i = 0; s->step.spring_capacity > 0 && i < s->body_count; i++) {
        const scene_thread *b = find_rolling_thread(&s->bodies[i]);
        if (b != NULL) {
            mark_exact_spans(s, b);
        }
    }
}

static vbss_result list_springs(scene_object *s, scene_thread *b)
{
    const thread_object *t = b->thread;
    b->first_spring = s->step.spring_count;
    for (uint32_t k = 0; k < t->twist_span_count; k++) {
        if (!has_roll(&t->twist_spans[k])) {
            continue;
        }
        if (s->step.spring_count == s->step.spring_capacity) {
            return VBSS_ERROR_CAPACITY;
        }
        contact_spring *spring = &s->step.springs[s->step.spring_count++];
        set_spring(spring, b, k);
        VBSS_TRY(vbss_contact_register_spring(spring, s->system));
    }
    return VBSS_OK;
}

vbss_result vbss_scene_register_roll_springs(scene_object *s)
{
    s->step.spring_count = 0;
    for (uint32_t i = 0; s->step.spring_capacity > 0 && i < s->body_count; i++) {
        scene_thread *b = find_rolling_thread(&s->bodies[i]);
        if (b != NULL) {
            VBSS_TRY(list_springs(s, b));
        }
    }
    return VBSS_OK;
}

void vbss_scene_find_roll_spring_indices(scene_object *s)
{
    for (uint32_t i = 0; i < s->step.spring_count; i++) {
        vbss_contact_find_spring_indices(&s->step.springs[i], s->system);
    }
}

/* ---- the numbers */

/* Diagonals: the small mass of a roll, and any number for segments without one. */
static void clear_roll_blocks(const scene_object *s, const scene_thread *b)
{
    const thread_object *t = b->thread;
    const double inertia =
        SCENE_ROLL_MASS_RATIO * b->integration.inertia * t->config.linear_density;
    for (uint32_t i = 0; i < vbss_scene_count_roll_blocks(t); i++) {
        const uint32_t number = roll_block(b, i * SCENE_ROLLS_PER_BLOCK);
        double diagonal[SCENE_ROLLS_PER_BLOCK];
        for (uint32_t k = 0; k < SCENE_ROLLS_PER_BLOCK; k++) {
            const uint32_t segment = i * SCENE_ROLLS_PER_BLOCK + k;
            diagonal[k] = segment + 1 < t->node_count && t->has_roll[segment] != 0
                              ? inertia * t->rest[segment]
                              : s->config.contact_stiffness;
        }
        block_set(&s->system->diagonal[number],
                  mat3_diagonal(diagonal[0], diagonal[1], diagonal[2]));
        s->system->rhs[number] = vec3_zero();
    }
}

static void add_torque(const scene_object *s, const scene_thread *b, uint32_t segment, double force)
{
    const uint32_t component = segment % SCENE_ROLLS_PER_BLOCK;
    vec3 *f = &s->system->rhs[roll_block(b, segment)];
    *(component == 0 ? &f->x : component == 1 ? &f->y : &f->z) += force;
}

void vbss_scene_assemble_rolls(scene_object *s, const scene_thread *b)
{
    const thread_object *t = b->thread;
    const double inverse_radius = 1.0 / t->config.radius;
    contact_spring *spring = &s->step.springs[b->first_spring];
    clear_roll_blocks(s, b);
    for (uint32_t k = 0; t->roll_count > 0 && k < t->twist_span_count; k++) {
        const thread_twist_span *span = &t->twist_spans[k];
        if (!has_roll(span)) {
            continue;
        }
        set_spring(spring++, b, k);
        for (int end = 0; end < 2; end++) {
            if (span->roll_segment[end] != THREAD_NO_ROLL) {
                add_torque(s, b, span->roll_segment[end],
                           (end == 0 ? span->torque : -span->torque) * inverse_radius);
            }
        }
    }
}

void vbss_scene_advance_rolls(const scene_object *s, const scene_thread *b)
{
    thread_object *t = b->thread;
    for (uint32_t i = 0; i + 1 < t->node_count; i++) {
        const vec3 d = s->system->solution[roll_block(b, i)];
        const uint32_t component = i % SCENE_ROLLS_PER_BLOCK;
        if (t->has_roll[i] != 0) {
            t->roll_angles[i] += (component == 0   ? d.x
                                  : component == 1 ? d.y
                                                   : d.z) /
                                 t->config.radius;
        }
    }
}
