/* Removes duplicate contacts. Where segments of a thread or edges of a drain meet, each of them has
 * a contact about the same point. */
#include "scene/contacts/contacts.h"
#include "scene/world/world.h"

/* ---- segments of threads: if two share a node, the contact of the next one stays */

static bool is_repeated_by_next_segment(const scene_object *s, const contact_constraint *constraint)
{
    const contact_set *set = s->contacts;
    const double *barycentric = scene_geometry_of(s, constraint)->barycentric;
    contact_key key = constraint->key;
    double at[2] = {barycentric[0], barycentric[1]};
    bool a = at[0] == 1.0, b = key.kind == VBSS_SCENE_CONTACT_SEGMENTS && at[1] == 1.0;
    key.feature_a += a;
    key.feature_b += b;
    at[0] = a ? 0.0 : at[0];
    at[1] = b ? 0.0 : at[1];
    uint32_t other = a || b ? vbss_contact_find(set, &key) : UINT32_MAX;
    if (other == UINT32_MAX) {
        return false;
    }
    const double *found = scene_geometry_of(s, &set->constraints[other])->barycentric;
    return fabs(found[0] - at[0]) < 1e-9 && fabs(found[1] - at[1]) < 1e-9;
}

/* ---- edges of drains: more than two may share a node; the contact of the last stays */

/* Identifies the point where a feature is touched: an even number for a node, an odd one for the
 * interior of a feature. */
static uint32_t contact_point_id(const scene_object *s, uint32_t number, uint32_t feature,
                                 double at)
{
    const scene_body *b = vbss_scene_body(s, number);
    bool at_start = at == 0.0, at_end = at == 1.0;
    if (scene_has_triangles(b) && (at_start || at_end)) {
        return 2 * s->collision->shapes[b->shape]->edges[feature][at_end ? 1 : 0];
    }
    if (b->kind == SCENE_BODY_THREAD && (at_start || at_end)) {
        return 2 * (feature + (at_end ? 1 : 0));
    }
    return 2 * feature + 1; /* also at a capsule's end, which no other capsule shares */
}

static void set_contact_points(const scene_object *s, const contact_constraint *constraint)
{
    const contact_key *key = &constraint->key;
    scene_contact_geometry *geometry = scene_geometry_of(s, constraint);
    geometry->dedup_points[0] =
        contact_point_id(s, key->body_a, key->feature_a, geometry->barycentric[0]);
    geometry->dedup_points[1] =
        contact_point_id(s, key->body_b, key->feature_b, geometry->barycentric[1]);
    if (key->body_a == key->body_b && geometry->dedup_points[0] > geometry->dedup_points[1]) {
        uint32_t first = geometry->dedup_points[0];
        geometry->dedup_points[0] = geometry->dedup_points[1];
        geometry->dedup_points[1] = first;
    }
}

static bool has_same_points(const scene_object *s, const contact_constraint *a,
                            const contact_constraint *b)
{
    const uint32_t *p = scene_geometry_of(s, a)->dedup_points;
    const uint32_t *q = scene_geometry_of(s, b)->dedup_points;
    return p[0] == q[0] && p[1] == q[1] && a->key.kind == b->key.kind &&
           a->key.body_a == b->key.body_a && a->key.body_b == b->key.body_b;
}

/* Rows by their points. */
enum { BUCKETS = 256 };
static uint32_t bucket_of(const scene_contact_geometry *geometry)
{
    return (geometry->dedup_points[0] * 31u + geometry->dedup_points[1]) % BUCKETS;
}

static bool is_duplicate(const scene_object *s, uint32_t last[BUCKETS], uint32_t i)
{
    const contact_constraint *constraints = s->contacts->constraints;
    scene_contact_geometry *geometry = scene_geometry_of(s, &constraints[i]);
    uint32_t *bucket = &last[bucket_of(geometry)], k = *bucket;
    while (k != UINT32_MAX && !has_same_points(s, &constraints[i], &constraints[k])) {
        k = scene_geometry_of(s, &constraints[k])->dedup_next;
    }
    geometry->dedup_next = *bucket;
    *bucket = k == UINT32_MAX ? i : *bucket;
    return k != UINT32_MAX;
}

void vbss_scene_remove_duplicate_contacts(scene_object *s)
{
    contact_set *set = s->contacts;
    uint32_t last[BUCKETS], count = 0;
    for (uint32_t i = 0; i < BUCKETS; i++) {
        last[i] = UINT32_MAX;
    }
    for (uint32_t i = set->count; i > 0; i--) {
        const contact_constraint *constraint = &set->constraints[i - 1];
        uint32_t kind = constraint->key.kind;
        s->scratch.is_duplicate[i - 1] = false;
        if (kind == VBSS_SCENE_CONTACT_SIDES) {
            set_contact_points(s, constraint);
            s->scratch.is_duplicate[i - 1] = is_duplicate(s, last, i - 1);
        } else if (scene_is_segment_contact(kind)) {
            s->scratch.is_duplicate[i - 1] = is_repeated_by_next_segment(s, constraint);
        }
    }
    for (uint32_t i = 0; i < set->count; i++) {
        if (!s->scratch.is_duplicate[i]) {
            if (count < i) {
                vbss_contact_move(&set->constraints[count], &set->constraints[i]);
            }
            count++;
        }
    }
    set->count = count;
}
