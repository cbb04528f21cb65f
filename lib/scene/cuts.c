/* Cutting a thread in a scene: its part beyond the cut becomes a body of its own, with all that held it, and
 * what contact remembers goes with the features that it is about. */
#include "scene/cuts.h"
#include "base/check.h"
#include "base/error.h"
#include "scene/events.h"
#include "scene/holes.h"
#include "scene/contacts.h"
#include "scene/scene.h"

#include "collision/closest.h"

#include <string.h>

/* A cut is no smooth motion: so many steps are damped. */
enum { DAMPED_STEPS = 3 };

/* ---- the ends at a cut */

/* The arc from the end of one segment to the begin of the other across cuts; -1: they are not connected so,
 * or by more than `most`. Both parts of a divided segment count as if each were all of it. */
static double arc_across(const scene_object *s, const scene_body *a, uint32_t segment_a,
                         const scene_body *b, uint32_t segment_b, double max_arc)
{
    const scene_body *piece = b, *before = vbss_scene_body(s, b->thread.cut_from);
    double arc = 0.0;
    bool divided = b->thread.has_split_segment;
    for (uint32_t k = divided && before == a && segment_a + 2 == a->thread.thread->node_count ? 1
                                                                                              : 0;
         k < segment_b && arc < max_arc; k++) {
        arc += b->thread.thread->rest[k];
    }
    for (uint32_t steps = 0;
         before != NULL && before != a && arc < max_arc && steps < SCENE_MAX_THREADS; steps++) {
        const thread_object *t = before->thread.thread;
        for (uint32_t k = 0; k + 1 < t->node_count && arc < max_arc; k++) {
            arc += t->rest[k];
        }
        piece = before;
        before = vbss_scene_body(s, piece->thread.cut_from);
    }
    if (before != a) {
        return -1.0;
    }
    uint32_t end = a->thread.thread->node_count - 1;
    end -= divided && piece == b && segment_b == 0;
    for (uint32_t k = segment_a + 1; k < end && arc < max_arc; k++) {
        arc += a->thread.thread->rest[k];
    }
    return arc < max_arc ? arc : -1.0;
}

/* A hair less: who asks for an exact multiple of the distance gets it, as within a chain. */
#define EXCLUSION_ROUNDING 1e-12

static double excluded_arc(const scene_object *s, const scene_body *a, const scene_body *b)
{
    const collision_object *c = s->collision;
    return (1.0 - EXCLUSION_ROUNDING) * c->config.exclusion *
           vbss_collision_contact_distance(c, c->shapes[a->shape], c->shapes[b->shape]);
}

bool vbss_scene_is_excluded_across_cut(const scene_object *s, const scene_body *a,
                                       uint32_t segment_a, const scene_body *b, uint32_t segment_b)
{
    if (a == b || (a->thread.cut_from == 0 && b->thread.cut_from == 0)) {
        return false;
    }
    double max_arc = excluded_arc(s, a, b);
    return arc_across(s, a, segment_a, b, segment_b, max_arc) >= 0.0 ||
           arc_across(s, b, segment_b, a, segment_a, max_arc) >= 0.0;
}

static double segment_distance(const thread_object *t, uint32_t i, const thread_object *u,
                               uint32_t k)
{
    const vec3 *x = t->now.x + i, *y = u->now.x + k;
    double at[2];
    return vec3_norm(closest_between_edges(vec3_sub(x[1], x[0]), vec3_sub(y[1], y[0]),
                                           vec3_sub(y[0], x[0]), &at[0], &at[1]));
}

/* Whether some of the one that adjoins the other is nearer than touching. */
static bool do_ends_overlap(const scene_object *s, const scene_body *a, const scene_body *b)
{
    const thread_object *t = a->thread.thread, *u = b->thread.thread;
    double contact_distance = t->config.radius + u->config.radius;
    for (uint32_t k = 0; k + 1 < u->node_count; k++) {
        uint32_t i = t->node_count - 1, first = i;
        while (i > 0 && vbss_scene_is_excluded_across_cut(s, a, i - 1, b, k)) {
            i--;
            if (segment_distance(t, i, u, k) < contact_distance) {
                return true;
            }
        }
        if (i == first) {
            return false; /* all that follow are further still */
        }
    }
    return false;
}

void vbss_scene_update_cut_exclusions(scene_object *s)
{
    for (uint32_t i = 0; i < s->body_count; i++) {
        scene_body *b = &s->bodies[i];
        if (b->kind != SCENE_BODY_THREAD || b->thread.cut_from == 0) {
            continue;
        }
        const scene_body *before = vbss_scene_body(s, b->thread.cut_from);
        bool apart = true;
        for (uint32_t steps = 0; apart && before != NULL && steps < SCENE_MAX_THREADS; steps++) {
            apart = !do_ends_overlap(s, before, b);
            before = vbss_scene_body(s, before->thread.cut_from);
        }
        b->thread.cut_from = apart ? 0 : b->thread.cut_from;
    }
}

/* ---- what contact remembers */

typedef struct renumbering {
    const scene_body *old, *piece;
    thread_cut cut;
} renumbering;

static bool is_cut_segment(const renumbering *r, uint32_t number, uint32_t feature)
{
    return number == r->old->number && feature == r->cut.segment && r->cut.fraction < 1.0;
}

/* Which sides, by bits, lie on the cut segment beyond the cut. */
static uint8_t sides_beyond(const scene_object *s, const renumbering *r, const contact_key *key)
{
    bool segments = key->kind == VBSS_CONTACT_SEGMENTS;
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

/* Shapes found first are side a. */
static void order_sides(const scene_object *s, contact_warm_start_entry *m)
{
    contact_key *k = &m->key;
    if (k->kind == VBSS_CONTACT_SEGMENTS &&
        vbss_scene_body(s, k->body_a)->shape > vbss_scene_body(s, k->body_b)->shape) {
        *k = (contact_key){k->kind, k->body_b, k->feature_b, k->body_a, k->feature_a};
        m->tangential_force = vec3_neg(m->tangential_force);
    }
}

/* Ascending keys: Shell's gaps, as a whole run may have moved. */
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
        set->scratch_flags[i] = sides_beyond(s, r, &set->warm_start[i].key);
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
        renumber_side(r, node, (set->scratch_flags[i] & 1u) != 0, &k->body_a, &k->feature_a);
        if (k->kind == VBSS_CONTACT_SEGMENTS) {
            renumber_side(r, false, (set->scratch_flags[i] & 2u) != 0, &k->body_b, &k->feature_b);
        }
        order_sides(s, m);
    }
    if (set != NULL) {
        sort_warm_start(set);
    }
}

/* ---- what holds it */

/* Where the middle of what is held lies, both jaws keep all of it. */
static void move_grasp(scene_thread_grasp *g, const scene_body *old, const scene_body *piece,
                       const thread_cut *cut)
{
    bool paper = g->point_spacing == 0.0;                   /* of a node */
    double before = old->thread.thread->rest[cut->segment]; /* what is left of the segment */
    bool on_cut = !paper && g->segment == cut->segment && cut->fraction < 1.0;
    bool beyond = paper ? g->segment >= cut->first_piece_node
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
    t->damped_steps_left =
        t->damped_steps_left > DAMPED_STEPS ? t->damped_steps_left : DAMPED_STEPS;
    b->thread.contact_free_steps = 0;
    b->thread.has_contacts = b->thread.is_welded = false;
}

static void divide_thread(scene_object *s, scene_body *old, scene_body *piece,
                          const thread_cut *cut)
{
    thread_object *t = old->thread.thread, *u = piece->thread.thread;
    vbss_thread_apply_cut(t, u, cut);
    vbss_scene_activate_piece(s, piece);
    piece->number = ++s->last_body_number;
    for (uint32_t i = 0; i < s->body_count; i++) { /* what adjoined its end adjoins the piece's */
        scene_body *b = &s->bodies[i];
        b->thread.cut_from = b->thread.cut_from == old->number ? piece->number : b->thread.cut_from;
    }
    piece->thread.cut_from = old->number;
    piece->thread.has_split_segment = cut->fraction < 1.0;
    vbss_collision_resize_chain(s->collision, old->shape, t->node_count, t->rest);
    vbss_collision_resize_chain(s->collision, piece->shape, u->node_count, u->rest);
    vbss_scene_number_nodes(s);
}

void vbss_scene_emit_cut_event(scene_object *s, const scene_body *thread, const scene_body *piece,
                               double arc_length)
{
    uint32_t um = (uint32_t)(vbss_min(1e6 * arc_length, 4e9) + 0.5);
    vbss_scene_add_event(s, VBSS_EVENT_CUT, thread->number, piece != NULL ? piece->number : 0, um);
    vbss_scene_write_lost_event(s);
}

vbss_result vbss_scene_apply_cut(scene_object *s, scene_body *thread, double arc_length,
                                 scene_body **piece)
{
    renumbering r = {.old = thread};
    *piece = NULL;
    arc_length = vbss_scene_move_cut_out_of_holes(s, thread->number, arc_length);
    if (!(arc_length >= 0.0) ||
        !vbss_thread_locate_cut(thread->thread.thread, arc_length, &r.cut)) {
        return VBSS_ERROR_OUT_OF_RANGE;
    }
    scene_body *b = vbss_scene_find_spare(s, thread);
    if (b == NULL || s->last_body_number == UINT32_MAX) {
        vbss_scene_emit_cut_event(s, thread, NULL, arc_length);
        return VBSS_ERROR_CAPACITY;
    }
    r.piece = b;
    record_sides(s, &r);
    divide_thread(s, thread, b, &r.cut);
    move_to_piece(s, thread, b, &r.cut);
    renumber_warm_start(s, &r);
    request_damping(thread);
    request_damping(b);
    vbss_scene_emit_cut_event(s, thread, b, arc_length);
    vbss_scene_close_holes_of_short_threads(s);
    s->pattern_hash = 0;
    s->generation++;
    *piece = b;
    return VBSS_OK;
}

/* ---- for hosts */

vbss_result vbss_scene_cut_thread(vbss_scene *scene, uint32_t thread, double arc_length,
                                  uint32_t *piece)
{
    scene_object *s;
    VBSS_TRY(vbss_scene_open_for_edit(scene, &s));
    VBSS_TRY(vbss_check_pointer(s->context, piece, "piece"));
    scene_body *b = vbss_scene_require_body(s, thread, SCENE_BODY_THREAD), *new_piece;
    if (b == NULL) {
        return VBSS_ERROR_OUT_OF_RANGE;
    }
    const thread_object *t = b->thread.thread;
    VBSS_TRY(vbss_check_range(s->context, arc_length, 0.0,
                              vbss_thread_arc_length(t, t->node_count - 1), "arc_length"));
    vbss_result result = vbss_scene_apply_cut(s, b, arc_length, &new_piece);
    if (result == VBSS_ERROR_CAPACITY) {
        return vbss_fail(s->context, result, "all cuts of body %u are made", thread);
    }
    if (result != VBSS_OK) {
        return vbss_fail(s->context, result, "a cut at %g m is at an end", arc_length);
    }
    *piece = new_piece->number;
    return VBSS_OK;
}

vbss_result vbss_scene_get_thread(vbss_scene *scene, uint32_t body, vbss_thread **thread)
{
    scene_object *s;
    VBSS_TRY(vbss_scene_open(scene, &s));
    VBSS_TRY(vbss_check_pointer(s->context, thread, "thread"));
    *thread = NULL;
    const scene_body *b = vbss_scene_require_body(s, body, SCENE_BODY_THREAD);
    if (b == NULL) {
        return VBSS_ERROR_OUT_OF_RANGE;
    }
    *thread = (vbss_thread *)b->thread.slot;
    return VBSS_OK;
}
