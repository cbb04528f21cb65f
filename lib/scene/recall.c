/* What contacts remember from part to part, also when they have slid on to other features: along a thread to the next
 * number, on a drain to a side or triangle that has a node in common. */
#include "scene/rows.h"
#include "scene/scene.h"

static bool share_a_node(const scene_object *s, const scene_body *b, const contact_key *x,
                         const contact_key *y, bool is_b)
{
    uint32_t p[3], q[3];
    uint32_t count =
        vbss_scene_nodes_of(s, b, x->kind, is_b, is_b ? x->feature_b : x->feature_a, p);
    uint32_t others =
        vbss_scene_nodes_of(s, b, y->kind, is_b, is_b ? y->feature_b : y->feature_a, q);
    bool shared = false;
    for (uint32_t i = 0; i < count; i++) {
        for (uint32_t k = 0; k < others; k++) {
            shared = shared || p[i] == q[k];
        }
    }
    return shared;
}

/* Feature a of a key: of a thread node or segment, which are beside each other by number; of a rigid body a capsule. */
static bool are_beside(const scene_object *s, const scene_body *a, const contact_key *x,
                       const contact_key *y)
{
    if (a->kind == BODY_DRAIN) {
        return share_a_node(s, a, x, y, false);
    }
    if (a->kind == BODY_THREAD) {
        return x->feature_a + 1 >= y->feature_a && y->feature_a + 1 >= x->feature_a;
    }
    uint32_t one = x->kind == VBSS_CONTACT_POINT_FACE ? x->feature_a / 2 : x->feature_a;
    return one == (y->kind == VBSS_CONTACT_POINT_FACE ? y->feature_a / 2 : y->feature_a);
}

/* The nearest row beside it that has no other memory yet, or UINT32_MAX. */
static uint32_t find_next(const scene_object *s, const contact_key *key)
{
    const contact_set *set = s->contacts;
    const scene_body *a = vbss_scene_body(s, key->body_a), *b = vbss_scene_body(s, key->body_b);
    uint32_t best = UINT32_MAX;
    for (uint32_t i = 0; a != NULL && b != NULL && i < set->count; i++) {
        const contact_constraint *row = &set->constraints[i];
        if (scene_is_of_surface(row->key.kind) && row->solution.status == CONTACT_OPEN &&
            row->key.body_a == key->body_a && row->key.body_b == key->body_b &&
            (best == UINT32_MAX || row->start_gap < set->constraints[best].start_gap) &&
            are_beside(s, a, key, &row->key) && share_a_node(s, b, key, &row->key, true)) {
            best = i;
        }
    }
    return best;
}

/* Of a fold that is too deep, m/s: it opens at leisure. */
#define OPENS 0.02

/* A fold knows no inside: as its sides turn, other pairs are nearest, and those may begin far deeper than what they bear. What
 * they have not been pressed in by nobody has done: they are let off by no more than they open. In real time parts leave
 * overlaps that no force knows of; let be, these would grow from part to part. */
static void ease_folds(scene_object *s, double h)
{
    for (uint32_t i = 0; s->config.mode == VBSS_MODE_OFFLINE && i < s->contacts->count; i++) {
        contact_constraint *row = &s->contacts->constraints[i];
        bool folds = scene_is_of_surface(row->key.kind) && row->key.body_a == row->key.body_b;
        double borne = row->solution.status == CONTACT_OPEN
                           ? 0.0
                           : row->solution.normal_force / row->stiffness;
        double deeper = -row->start_gap - vbss_max(borne, OPENS * h);
        if (folds && deeper > 0.0) {
            row->fold_allowance = deeper;
            row->overlap_allowance += deeper;
            row->start_gap += deeper;
            row->gap += deeper;
        }
    }
}

void vbss_scene_recall_rows(scene_object *s, const scene_part *part)
{
    contact_set *set = s->contacts;
    vbss_contact_warm_start(set);
    for (uint32_t m = 0; m < set->warm_start_count; m++) {
        const contact_key *key = &set->warm_start[m].key;
        if (set->scratch_flags[m] != 0) {
            continue;
        }
        if (!scene_is_of_surface(key->kind)) {
            vbss_contact_warm_start_neighbour(set, m);
            continue;
        }
        uint32_t row = find_next(s, key);
        if (row != UINT32_MAX) {
            vbss_contact_warm_start_one(set, m, row);
        }
    }
    ease_folds(s, part->h);
}
