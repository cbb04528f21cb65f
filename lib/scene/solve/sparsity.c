/* Sparsity: chooses separators and builds the system's sparsity pattern. Only the part that has
 * changed is built again. */
#include "base/error.h"
#include "scene/contacts/contacts.h"
#include "scene/solve/solve.h"
#include "scene/tissue/tissue.h"
#include "scene/world/world.h"
#include "thread/twist.h"

#include <string.h>

enum { NODE_INTERIOR, NODE_SEPARATOR };

/* ---- separators */

static void add_separator(scene_object *s, const scene_body *b, uint32_t node)
{
    s->step.is_separator[b->thread.first_node + node] = NODE_SEPARATOR;
}

static void add_separator_range(scene_object *s, const scene_body *b, uint32_t low, uint32_t high)
{
    uint32_t last = b->thread.thread->node_count - 1;
    for (uint32_t i = low; i <= high && i <= last; i++) {
        add_separator(s, b, i);
    }
}

static void add_drain_separators(const scene_object *s, const scene_body *b, const contact_key *key,
                                 bool is_b)
{
    uint32_t nodes[3];
    uint32_t count = vbss_scene_surface_feature_nodes(
        s, b, key->kind, is_b, is_b ? key->feature_b : key->feature_a, nodes);
    for (uint32_t k = 0; k < count; k++) {
        b->drain.is_separator[nodes[k]] = NODE_SEPARATOR;
    }
}

static void add_side_separators(scene_object *s, const contact_constraint *constraint, bool is_b)
{
    const contact_key *key = &constraint->key;
    uint32_t number = is_b ? key->body_b : key->body_a,
             feature = is_b ? key->feature_b : key->feature_a;
    const scene_body *b = vbss_scene_body(s, number);
    if (b != NULL && b->kind == SCENE_BODY_DRAIN) {
        add_drain_separators(s, b, key, is_b);
        return;
    }
    if (b == NULL || b->kind != SCENE_BODY_THREAD) {
        return;
    }
    switch (key->kind) {
    case VBSS_SCENE_CONTACT_NODE_CAPSULE:
        add_separator_range(s, b, feature > 0 ? feature - 1 : 0, feature + 1);
        break;
    case VBSS_SCENE_CONTACT_NODE_FLOOR:
    case VBSS_SCENE_CONTACT_POINT_FACE:
        add_separator(s, b, feature);
        break;
    case VBSS_SCENE_CONTACT_SEGMENTS:
        feature = scene_geometry_of(s, constraint)->segments[is_b ? 1 : 0];
        add_separator_range(s, b, feature, feature + 1);
        break;
    default:
        add_separator_range(s, b, feature, feature + 1);
    }
}

static void add_wall_grasp_separators(const scene_object *s, const contact_constraint *constraint)
{
    const scene_drain *b = &vbss_scene_body(s, constraint->key.body_a)->drain;
    const scene_wall_grasp *p = &vbss_scene_body(s, constraint->key.body_b)->rigid.wall_grasp;
    for (uint32_t i = 0; i < 3; i++) {
        b->is_separator[b->drain->mesh.triangles[p->triangle[constraint->key.feature_a]][i]] = 1;
    }
}

/* Nodes of a grasped wall or thread become separators. */
static void add_bilateral_separators(scene_object *s, const contact_constraint *constraint)
{
    const scene_body *b = vbss_scene_body(s, constraint->key.body_a);
    if (b->kind == SCENE_BODY_DRAIN) {
        add_wall_grasp_separators(s, constraint);
        return;
    }
    if (b->kind == SCENE_BODY_RIGID) { /* blocks of rigid bodies are separators already */
        return;
    }
    const thread_object *t = b->thread.thread;
    for (uint32_t k = 0; k < constraint->jacobian_block_count; k++) {
        uint32_t node = constraint->jacobian[k].block - b->thread.first_block;
        if (constraint->jacobian[k].block >= b->thread.first_block && node < t->node_count) {
            add_separator(s, b, node);
        }
    }
}

/* Whether a pin is a weld of bodies that are not frozen. */
static bool is_active_weld(const scene_object *s, const scene_pin *p)
{
    return p->id != 0 && p->attachment == 0 && !vbss_scene_body(s, p->thread)->is_frozen;
}

static void add_weld_separators(scene_object *s)
{
    for (uint32_t i = 0; i < s->config.pin_capacity; i++) {
        const scene_pin *p = &s->pins[i];
        if (is_active_weld(s, p)) {
            const scene_body *b = vbss_scene_body(s, p->thread);
            uint32_t reach = vbss_thread_bandwidth(b->thread.thread);
            add_separator_range(s, b, p->node > reach ? p->node - reach : 0, p->node + reach);
        }
    }
}

/* Widens groups of separators to the bandwidth, and joins groups if the run between them is too
 * short to be worth its fill-in. */
static void widen_separators(const thread_object *t, uint8_t *is_separator)
{
    uint32_t n = t->node_count, reach = vbss_thread_bandwidth(t), run_length = reach + 1;
    for (uint32_t i = 0; i < n; i++) {
        if (is_separator[i] != NODE_INTERIOR) {
            for (uint32_t k = 1; run_length <= reach && k <= run_length; k++) {
                is_separator[i - k] = NODE_SEPARATOR;
            }
            run_length = 0;
        } else {
            run_length += run_length <= reach;
        }
    }
    uint32_t width = 0;
    for (uint32_t i = 0; i < n; i++) {
        if (is_separator[i] != NODE_INTERIOR) {
            width++;
        } else if (width > 0 && width < reach) {
            is_separator[i] = NODE_SEPARATOR;
            width++;
        } else {
            width = 0;
        }
    }
    for (; width > 0 && width < reach && width < n; width++) {
        is_separator[n - 1 - width] = NODE_SEPARATOR; /* a group at the end grows backward */
    }
}

static void add_hole_separators(const scene_object *s, const contact_constraint *constraint)
{
    const suture_hole *hole = &s->holes[constraint->key.feature_a];
    const scene_hole_context p = vbss_scene_get_hole_context(s, hole);
    for (uint32_t k = 0; k < 3 && p.wall_body->kind == SCENE_BODY_DRAIN; k++) {
        p.wall_body->drain.is_separator[p.wall.triangles[hole->triangle][k]] = 1;
    }
    for (uint32_t k = 0; p.thread != NULL && k < constraint->jacobian_block_count; k++) {
        uint32_t node = constraint->jacobian[k].block - p.thread->thread.first_block;
        if (constraint->jacobian[k].block >= p.thread->thread.first_block &&
            node < p.now.thread->node_count) {
            s->step.is_separator[p.thread->thread.first_node + node] = 1;
        }
    }
}

static void choose_separators(scene_object *s)
{
    memset(s->step.is_separator, NODE_INTERIOR, s->node_count);
    for (uint32_t i = 0; i < s->body_count; i++) {
        if (s->bodies[i].kind == SCENE_BODY_DRAIN) {
            scene_drain *b = &s->bodies[i].drain;
            memset(b->is_separator, NODE_INTERIOR,
                   b->drain->mesh.node_count * sizeof *b->is_separator);
        }
    }
    for (uint32_t i = 0; i < s->contacts->count; i++) {
        const contact_constraint *constraint = &s->contacts->constraints[i];
        if (constraint->key.kind == VBSS_SCENE_CONTACT_HOLE) {
            add_hole_separators(s, constraint);
        } else if (constraint->is_bilateral) {
            add_bilateral_separators(s, constraint);
        } else {
            add_side_separators(s, constraint, false);
            add_side_separators(s, constraint, true);
        }
    }
    add_weld_separators(s);
    for (uint32_t i = 0; i < s->body_count; i++) {
        if (s->bodies[i].kind == SCENE_BODY_THREAD) {
            const thread_object *t = s->bodies[i].thread.thread;
            widen_separators(t, s->step.is_separator + s->bodies[i].thread.first_node);
        }
    }
}

/* ---- welds */

/* Adds bodies of neighbours that earlier welds have eliminated, as these bodies take their
 * place. */
static void add_bodies_of_neighbours(const scene_object *s, contact_weld *w)
{
    uint32_t count = w->neighbour_count;
    for (const contact_weld *earlier = s->step.welds; earlier < w; earlier++) {
        for (uint32_t k = 0; k < count; k++) {
            if (w->neighbours[k] == earlier->node) {
                w->neighbours[w->neighbour_count++] = earlier->translation;
                w->neighbours[w->neighbour_count++] = earlier->rotation;
            }
        }
    }
}

static void list_welds(scene_object *s)
{
    s->step.weld_count = 0;
    for (uint32_t i = 0; i < s->config.pin_capacity; i++) {
        const scene_pin *p = &s->pins[i];
        if (!is_active_weld(s, p)) {
            continue;
        }
        const scene_body *t = vbss_scene_body(s, p->thread), *b = vbss_scene_body(s, p->body);
        uint32_t first = t->thread.first_block, n = t->thread.thread->node_count;
        uint32_t reach = vbss_thread_bandwidth(t->thread.thread);
        contact_weld *w = &s->step.welds[s->step.weld_count++];
        *w = (contact_weld){.node = first + p->node,
                            .translation = b->rigid.blocks.first,
                            .rotation = b->rigid.blocks.first + 1};
        for (uint32_t k = 1; k <= reach; k++) {
            if (p->node >= k) {
                w->neighbours[w->neighbour_count++] = first + p->node - k;
            }
            if (p->node + k < n) {
                w->neighbours[w->neighbour_count++] = first + p->node + k;
            }
        }
        add_bodies_of_neighbours(s, w);
    }
}

void vbss_scene_set_weld_arms(scene_object *s)
{
    uint32_t w = 0;
    for (uint32_t i = 0; i < s->config.pin_capacity; i++) {
        const scene_pin *p = &s->pins[i];
        if (is_active_weld(s, p)) {
            const scene_rigid *r = &vbss_scene_body(s, p->body)->rigid;
            s->step.welds[w++].arm = quat_rotate(r->trial.orientation, p->point);
        }
    }
}

/* ---- sparsity pattern */

/* A faster hash than that of snapshots. It is computed in each attempt and never leaves
 * the scene. */
static uint64_t mix(uint64_t hash, uint64_t word)
{
    hash = (hash ^ word) * UINT64_C(0x9e3779b97f4a7c15);
    return hash ^ hash >> 29;
}

static uint64_t mix_two(uint64_t hash, uint32_t a, uint32_t b)
{
    return mix(hash, (uint64_t)a << 32 | b);
}

static uint64_t mix_flags(uint64_t hash, const uint8_t *flags, uint32_t count)
{
    for (uint32_t i = 0; i < count; i += 64) {
        uint64_t bits = 0;
        for (uint32_t k = 0; k < 64 && i + k < count; k++) {
            bits |= (uint64_t)(flags[i + k] != NODE_INTERIOR) << k;
        }
        hash = mix(hash, bits);
    }
    return hash;
}

static uint64_t mix_constraint(uint64_t hash, const contact_constraint *constraint)
{
    hash = mix_two(hash, constraint->key.kind, constraint->key.feature_a);
    hash = mix_two(hash, constraint->key.body_a, constraint->key.body_b);
    hash = mix_two(hash, constraint->key.feature_b, constraint->jacobian_block_count);
    /* Bilateral constraints and contacts of two threads slide to other blocks. */
    bool slides = constraint->is_bilateral || constraint->key.kind == VBSS_SCENE_CONTACT_SEGMENTS;
    for (uint32_t k = 0; slides && k < constraint->jacobian_block_count; k++) {
        hash = mix(hash, constraint->jacobian[k].block);
    }
    return hash;
}

static uint64_t mix_attachments(uint64_t hash, const thread_object *t)
{
    for (uint32_t k = 0; k < t->config.attachment_capacity; k++) {
        const thread_attachment *a = &t->attachments[k];
        hash = mix(mix_two(hash, a->id, (uint32_t)a->kind), a->node);
    }
    return hash;
}

static uint64_t mix_touched(uint64_t hash, const scene_host_surface *h)
{
    hash = mix(hash, h->touched_count);
    for (uint32_t i = 0; i < h->touched_count; i++) {
        hash = mix_two(hash, h->touched[i], scene_has_compliance(h, h->touched[i]));
    }
    return hash;
}

/* Hash of all that register_bodies and list_welds depend on: bodies, separators,
 * attachments, pins. */
static uint64_t hash_bodies(const scene_object *s)
{
    uint64_t hash = mix_flags(s->node_count, s->step.is_separator, s->node_count);
    for (uint32_t i = 0; i < s->config.pin_capacity; i++) {
        const scene_pin *p = &s->pins[i];
        hash = mix_two(mix_two(hash, p->id, p->thread), p->node, p->body);
        hash = mix(hash, p->attachment);
    }
    for (uint32_t i = 0; i < s->body_count; i++) {
        const scene_body *b = &s->bodies[i];
        hash = mix_two(hash, (uint32_t)scene_active_kind(b), b->number);
        if (b->kind == SCENE_BODY_THREAD) {
            const thread_object *t = b->thread.thread;
            hash = mix_attachments(hash, t);
            if (thread_has_friction_torque(t)) {
                hash = mix_flags(hash, t->has_roll, t->node_count - 1);
            }
        } else if (b->kind == SCENE_BODY_DRAIN) {
            uint32_t nodes = b->drain.drain->mesh.node_count;
            hash = mix_flags(hash, b->drain.is_separator, nodes);
            hash = mix_flags(hash, b->drain.drain->anchored, nodes);
        } else if (scene_is_compliant(scene_host_surface_of(b))) {
            hash = mix_touched(hash, b->rigid.surface);
        }
    }
    return hash;
}

/* Hash of bodies and constraints; never 0. */
static uint64_t hash_pattern(const scene_object *s, uint64_t body_hash)
{
    uint64_t hash = body_hash;
    for (uint32_t i = 0; i < s->contacts->count; i++) {
        hash = mix_constraint(hash, &s->contacts->constraints[i]);
    }
    return hash | 1u;
}

static uint32_t *first_block_of(scene_body *b)
{
    return b->kind == SCENE_BODY_THREAD  ? &b->thread.first_block
           : b->kind == SCENE_BODY_RIGID ? &b->rigid.blocks.first
                                         : &b->drain.first_block;
}

static uint32_t count_blocks(const scene_body *b)
{
    return b->kind == SCENE_BODY_THREAD
               ? b->thread.thread->node_count + vbss_scene_count_roll_blocks(b->thread.thread)
           : b->kind == SCENE_BODY_RIGID
               ? 2 + (scene_is_compliant(b->rigid.surface) ? b->rigid.surface->touched_count : 0)
           : b->kind == SCENE_BODY_DRAIN ? b->drain.drain->mesh.node_count
                                         : 0;
}

/* A frozen body has blocks, as constraints name them, but no equations. */
static vbss_result register_frozen_body(scene_object *s, scene_body *b)
{
    const uint32_t count = count_blocks(b);
    if (count == 0) {
        return VBSS_OK;
    }
    uint32_t *first = first_block_of(b);
    VBSS_TRY(vbss_system_add_chain(s->system, count, first));
    for (uint32_t i = 0; i < count; i++) {
        vbss_system_set_role(s->system, *first + i, VBSS_ROLE_PRESCRIBED);
    }
    return VBSS_OK;
}

static vbss_result register_bodies(scene_object *s)
{
    for (uint32_t i = 0; i < s->body_count; i++) {
        scene_body *b = &s->bodies[i];
        if (b->is_frozen) {
            VBSS_TRY(register_frozen_body(s, b));
        } else if (b->kind == SCENE_BODY_THREAD) {
            VBSS_TRY(vbss_thread_add_to_system(b->thread.thread, s->system,
                                               s->step.is_separator + b->thread.first_node,
                                               &b->thread.first_block));
            VBSS_TRY(vbss_scene_register_rolls(s, &b->thread));
        } else if (b->kind == SCENE_BODY_RIGID) {
            vbss_role role = b->rigid.kind == VBSS_SCENE_RIGID_DRIVEN ? VBSS_ROLE_PRESCRIBED
                                                                      : VBSS_ROLE_SEPARATOR;
            VBSS_TRY(vbss_rigid_register(s->system, role, &b->rigid.blocks));
            VBSS_TRY(vbss_scene_register_touched_vertices(s, &b->rigid));
        } else if (b->kind == SCENE_BODY_DRAIN) {
            VBSS_TRY(vbss_drain_add_to_system(b->drain.drain, s->system, b->drain.is_separator,
                                              &b->drain.first_block));
        }
    }
    return VBSS_OK;
}

void vbss_scene_number_blocks(scene_object *s)
{
    uint32_t first = 0;
    vbss_scene_list_touched_vertices(s);
    for (uint32_t i = 0; i < s->body_count; i++) {
        scene_body *b = &s->bodies[i];
        if (b->kind != SCENE_BODY_NONE) {
            *first_block_of(b) = first;
            first += count_blocks(b);
        }
    }
}

static void drop_factors(scene_object *s)
{
    for (uint32_t i = 0; i < s->body_count; i++) {
        if (s->bodies[i].kind == SCENE_BODY_DRAIN) {
            s->bodies[i].drain.drain->factored_in = NULL;
        }
    }
}

/* Registers bodies only if they or their separators have changed; else drops the couplings
 * of contacts. */
static vbss_result begin_pattern(scene_object *s, bool same_bodies)
{
    if (same_bodies) {
        vbss_system_reset_separator_couplings(s->system);
        return VBSS_OK;
    }
    vbss_system_begin_pattern(s->system);
    drop_factors(s);
    VBSS_TRY(register_bodies(s));
    list_welds(s);
    return VBSS_OK;
}

vbss_result vbss_scene_build_sparsity_pattern(scene_object *s)
{
    choose_separators(s);
    vbss_scene_mark_exact_spans(s);
    uint64_t body_hash = hash_bodies(s), pattern_hash = hash_pattern(s, body_hash);
    if (pattern_hash == s->step.pattern_hash) {
        vbss_contact_assign_schur_offsets(s->contacts);
        return VBSS_OK;
    }
    bool same_bodies = s->step.pattern_hash != 0 && body_hash == s->step.body_pattern_hash;
    s->step.pattern_hash = 0;
    s->step.body_pattern_hash = body_hash;
    s->report.statistics.patterns++;
    VBSS_TRY(begin_pattern(s, same_bodies));
    for (uint32_t i = 0; i < s->step.weld_count; i++) {
        VBSS_TRY(vbss_contact_register_weld(&s->step.welds[i], s->system));
    }
    VBSS_TRY(vbss_scene_register_roll_springs(s));
    VBSS_TRY(vbss_contact_register(s->contacts, s->system));
    VBSS_TRY(vbss_system_analyse(s->system));
    vbss_scene_find_roll_spring_indices(s);
    vbss_contact_find_schur_indices(s->contacts, s->system);
    for (uint32_t i = 0; !same_bodies && i < s->body_count; i++) {
        if (scene_active_kind(&s->bodies[i]) == SCENE_BODY_DRAIN) {
            vbss_drain_set_assembly_map(s->bodies[i].drain.drain, s->system);
        }
    }
    s->step.pattern_hash = pattern_hash;
    return VBSS_OK;
}

vbss_result vbss_scene_prepare_pattern(scene_object *s)
{
    const uint32_t constraints = s->contacts->count;
    s->contacts->count = 0;
    vbss_scene_choose_rolls(s);
    vbss_scene_number_blocks(s);
    const vbss_result result = vbss_scene_build_sparsity_pattern(s);
    s->contacts->count = constraints;
    return result;
}
