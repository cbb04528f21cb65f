/* Cuts of threads in a scene. The part beyond the cut becomes a body of its own, together with
 * its pins, grasps and holes; the warm start of contacts follows the features. */
#include "base/error.h"
#include "collision/closest.h"
#include "scene/tissue/tissue.h"
#include "scene/tools/tools.h"
#include "scene/topology/topology.h"
#include "scene/tuning.h"
#include "scene/world/world.h"

/* ---- warm start */

typedef struct renumbering {
    const scene_body *old, *piece;
    thread_cut cut;
} renumbering;

static bool is_cut_segment(const renumbering *r, uint32_t number, uint32_t feature)
{
    return number == r->old->number && feature == r->cut.segment && r->cut.fraction < 1.0;
}

/* Sides of a contact that lie on the cut segment beyond the cut: bit 0 for side a, bit 1 for
 * side b. */
static uint8_t sides_beyond(const scene_object *s, const renumbering *r, const contact_key *key)
{
    bool segments = key->kind == VBSS_SCENE_CONTACT_SEGMENTS;
    bool a = scene_is_segment_contact(key->kind) && is_cut_segment(r, key->body_a, key->feature_a);
    bool b = segments && is_cut_segment(r, key->body_b, key->feature_b);
    vec3 x[2], y[2];
    double at[2];
    if (!(a || b) || !vbss_scene_feature_segment(s, key->body_a, key->feature_a, x) ||
        !vbss_scene_feature_segment(s, key->body_b, key->feature_b, y)) {
        return 0;
    }
    (void)closest_between_edges(vec3_sub(x[1], x[0]), vec3_sub(y[1], y[0]), vec3_sub(y[0], x[0]),
                                &at[0], &at[1]);
    return (uint8_t)((a && at[0] > r->cut.fraction) | (b && at[1] > r->cut.fraction) << 1);
}

static void renumber_side(const renumbering *r, bool node, bool beyond, uint32_t *number,
                          uint32_t *feature)
{
    if (*number != r->old->number) {
        return;
    }
    beyond = beyond || *feature >= r->cut.first_piece_node || (!node && *feature > r->cut.segment);
    if (beyond) {
        *number = r->piece->number;
        *feature -= r->cut.node_shift;
    }
}

/* Side a of a contact of two segments is the shape with the lower number. */
static void order_sides(const scene_object *s, contact_warm_start_entry *m)
{
    contact_key *k = &m->key;
    if (k->kind == VBSS_SCENE_CONTACT_SEGMENTS &&
        vbss_scene_body(s, k->body_a)->shape > vbss_scene_body(s, k->body_b)->shape) {
        *k = (contact_key){k->kind, k->body_b, k->feature_b, k->body_a, k->feature_a};
        m->tangential_force = vec3_neg(m->tangential_force);
    }
}

/* Shell sort by keys, because a whole run of entries may have moved. */
static void sort_warm_start(contact_set *set)
{
    uint32_t n = set->warm_start_count, stride = 1;
    while (stride < n / 3) {
        stride = 3 * stride + 1;
    }
    for (; stride > 0; stride /= 3) {
        for (uint32_t i = stride; i < n; i++) {
            const contact_warm_start_entry m = set->warm_start[i];
            uint32_t to = i;
            while (to >= stride &&
                   vbss_contact_compare_keys(&set->warm_start[to - stride].key, &m.key) > 0) {
                set->warm_start[to] = set->warm_start[to - stride];
                to -= stride;
            }
            set->warm_start[to] = m;
        }
    }
}

static void record_sides(scene_object *s, const renumbering *r)
{
    contact_set *set = s->contacts;
    for (uint32_t i = 0; set != NULL && i < set->warm_start_count; i++) {
        s->scratch.sides_beyond_cut[i] = sides_beyond(s, r, &set->warm_start[i].key);
    }
}

static void renumber_warm_start(scene_object *s, const renumbering *r)
{
    contact_set *set = s->contacts;
    for (uint32_t i = 0; set != NULL && i < set->warm_start_count; i++) {
        contact_warm_start_entry *m = &set->warm_start[i];
        contact_key *k = &m->key;
        bool node = scene_is_node_contact(k->kind);
        if (!node && !scene_is_segment_contact(k->kind)) {
            continue;
        }
        renumber_side(r, node, (s->scratch.sides_beyond_cut[i] & 1u) != 0, &k->body_a,
                      &k->feature_a);
        if (k->kind == VBSS_SCENE_CONTACT_SEGMENTS) {
            renumber_side(r, false, (s->scratch.sides_beyond_cut[i] & 2u) != 0, &k->body_b,
                          &k->feature_b);
        }
        order_sides(s, m);
    }
    if (set != NULL) {
        sort_warm_start(set);
    }
}

/* ---- grasps, holes and pins */

/* The body that has the middle of the grasp keeps the whole grasp. */
static void move_grasp(scene_thread_grasp *g, const scene_body *old, const scene_body *piece,
                       const thread_cut *cut)
{
    bool is_of_node = g->point_spacing == 0.0;              /* `segment` is a node */
    double before = old->thread.thread->rest[cut->segment]; /* part of the segment that stays */
    bool on_cut = !is_of_node && g->segment == cut->segment && cut->fraction < 1.0;
    bool beyond = is_of_node ? g->segment >= cut->first_piece_node
                             : g->segment > cut->segment || (on_cut && g->segment_offset > before);
    if (g->id != 0 && g->thread == old->number && beyond) {
        g->thread = piece->number;
        g->segment -= cut->node_shift;
        g->segment_offset -= on_cut ? before : 0.0;
    }
}

static void move_to_piece(scene_object *s, const scene_body *old, const scene_body *piece,
                          const thread_cut *cut)
{
    for (uint32_t i = 0; i < s->config.grasp_capacity; i++) {
        move_grasp(&s->thread_grasps[i], old, piece, cut);
    }
    const thread_object *t = old->thread.thread;
    vbss_scene_divide_holes(s, old->number, piece->number,
                            vbss_thread_arc_length(t, t->node_count - 1));
    for (uint32_t i = 0; i < s->config.pin_capacity; i++) {
        scene_pin *p = &s->pins[i];
        if (p->id != 0 && p->thread == old->number && p->node >= cut->first_piece_node) {
            p->thread = piece->number;
            p->node -= cut->node_shift;
        }
    }
}

/* ---- the cut */

static void request_damping(scene_body *b)
{
    thread_object *t = b->thread.thread;
    t->damped_steps_left = t->damped_steps_left > SCENE_CUT_DAMPED_STEPS ? t->damped_steps_left
                                                                         : SCENE_CUT_DAMPED_STEPS;
    b->thread.contact_free_steps = 0;
    b->thread.has_contacts = b->thread.is_welded = false;
}

static void divide_thread(scene_object *s, scene_body *old, scene_body *piece,
                          const thread_cut *cut)
{
    thread_object *t = old->thread.thread, *u = piece->thread.thread;
    vbss_thread_apply_cut(t, u, cut);
    vbss_scene_activate_piece(s, piece);
    vbss_scene_set_body_number(s, piece, ++s->last_body_number);
    /* a piece whose first node was next to the end of `old` is now next to that of the new piece */
    for (uint32_t i = 0; i < s->body_count; i++) {
        scene_body *b = &s->bodies[i];
        if (b->kind == SCENE_BODY_THREAD && b->thread.cut_from == old->number) {
            b->thread.cut_from = piece->number;
        }
    }
    piece->filter = old->filter;
    piece->user_data = NULL;
    u->gravity = t->gravity;
    piece->next_halvings = old->next_halvings;
    piece->thread.cut_from = old->number;
    piece->thread.has_split_segment = cut->fraction < 1.0;
    vbss_collision_resize_chain(s->collision, old->shape, t->node_count, t->rest);
    vbss_collision_resize_chain(s->collision, piece->shape, u->node_count, u->rest);
    vbss_scene_number_nodes(s);
}

/* Finds where the thread is cut, beside its holes, and the spare for the piece. */
static vbss_result prepare_cut(scene_object *s, const scene_body *thread, double *arc_length,
                               thread_cut *cut, scene_body **spare)
{
    *arc_length = vbss_scene_move_cut_out_of_holes(s, thread->number, *arc_length);
    if (!(*arc_length >= 0.0) || !vbss_thread_locate_cut(thread->thread.thread, *arc_length, cut)) {
        return VBSS_ERROR_OUT_OF_RANGE;
    }
    *spare = vbss_scene_find_spare(s, thread);
    if (*spare == NULL || s->last_body_number == UINT32_MAX) {
        const vec3 *x = &thread->thread.thread->now.x[cut->segment];
        vbss_scene_emit_cut_event(s, thread, NULL, *arc_length,
                                  vec3_lerp(x[0], x[1], cut->fraction));
        return VBSS_ERROR_CAPACITY;
    }
    return VBSS_OK;
}

vbss_result vbss_scene_check_cut(scene_object *s, const scene_body *thread, double arc_length)
{
    thread_cut cut;
    scene_body *spare;
    return prepare_cut(s, thread, &arc_length, &cut, &spare);
}

vbss_result vbss_scene_apply_cut(scene_object *s, scene_body *thread, double arc_length,
                                 scene_body **piece)
{
    renumbering r = {.old = thread};
    scene_body *b;
    *piece = NULL;
    VBSS_TRY(prepare_cut(s, thread, &arc_length, &r.cut, &b));
    r.piece = b;
    record_sides(s, &r);
    divide_thread(s, thread, b, &r.cut);
    move_to_piece(s, thread, b, &r.cut);
    renumber_warm_start(s, &r);
    request_damping(thread);
    request_damping(b);
    vbss_scene_emit_cut_event(s, thread, b, arc_length, b->thread.thread->now.x[0]);
    vbss_scene_close_holes_of_short_threads(s);
    s->step.pattern_hash = 0;
    s->report.generation++;
    *piece = b;
    return VBSS_OK;
}

void vbss_scene_make_cuts(scene_object *s)
{
    for (uint32_t i = 0; i < s->step.cut_count; i++) {
        scene_body *thread = vbss_scene_body(s, s->step.cuts[i].thread), *piece;
        /* another cut may have made it an end */
        if (!vbss_scene_is_at_thread_end(thread->thread.thread, s->step.cuts[i].arc_length)) {
            (void)vbss_scene_apply_cut(s, thread, s->step.cuts[i].arc_length, &piece);
        }
    }
    s->step.cut_count = 0;
}
