/* Overlaps of prescribed bodies: pairs that the host has placed in each other.
 *
 * Nothing can push two driven bodies apart. A pair that overlaps when the second body is added is
 * therefore not tested for collision until it has come apart. Bodies that were apart stop each
 * other. */
#include "collision/closest.h"
#include "scene/world/world.h"

static bool is_driven(const scene_body *b)
{
    return b != NULL && b->kind == SCENE_BODY_RIGID && b->rigid.kind == VBSS_SCENE_RIGID_DRIVEN;
}

static double capsule_gap(const scene_capsule *a, const scene_capsule *b)
{
    double s, u;
    vec3 apart =
        closest_between_edges(vec3_sub(a->now[1], a->now[0]), vec3_sub(b->now[1], b->now[0]),
                              vec3_sub(b->now[0], a->now[0]), &s, &u);
    return vec3_norm(apart) - a->radius - b->radius;
}

/* Whether the surfaces of two rigid bodies overlap where they are now. */
static bool do_overlap(const scene_object *s, const scene_rigid *a, const scene_rigid *b)
{
    for (uint32_t i = 0; i < a->capsule_count; i++) {
        for (uint32_t k = 0; k < b->capsule_count; k++) {
            if (capsule_gap(&s->capsules[a->first_capsule + i],
                            &s->capsules[b->first_capsule + k]) < 0.0) {
                return true;
            }
        }
    }
    return false;
}

static void set_capsules(scene_object *s, const scene_rigid *r)
{
    for (uint32_t i = r->first_capsule; i < r->first_capsule + r->capsule_count; i++) {
        vbss_scene_transform_capsule(&s->capsules[i], r->body.now.pose, s->capsules[i].now);
    }
}

void vbss_scene_list_overlaps_of(scene_object *s, const scene_body *b)
{
    set_capsules(s, &b->rigid);
    for (uint32_t i = 0; i < s->body_count && is_driven(b); i++) {
        const scene_body *other = &s->bodies[i];
        if (other == b || !is_driven(other)) {
            continue;
        }
        set_capsules(s, &other->rigid);
        if (s->overlap_count < SCENE_MAX_OVERLAPS && do_overlap(s, &b->rigid, &other->rigid)) {
            s->overlaps[s->overlap_count++] = (scene_touching_pair){other->number, b->number};
        }
    }
}

void vbss_scene_drop_ended_overlaps(scene_object *s)
{
    uint32_t count = 0;
    for (uint32_t i = 0; i < s->overlap_count; i++) {
        const scene_body *a = vbss_scene_body(s, s->overlaps[i].body_a),
                         *b = vbss_scene_body(s, s->overlaps[i].body_b);
        if (!is_driven(a) || !is_driven(b)) {
            continue;
        }
        set_capsules(s, &a->rigid);
        set_capsules(s, &b->rigid);
        if (do_overlap(s, &a->rigid, &b->rigid)) {
            s->overlaps[count++] = s->overlaps[i];
        }
    }
    s->overlap_count = count;
}

bool vbss_scene_is_overlap(const scene_object *s, const scene_body *a, const scene_body *b)
{
    for (uint32_t i = 0; i < s->overlap_count; i++) {
        const scene_touching_pair *pair = &s->overlaps[i];
        if ((pair->body_a == a->number && pair->body_b == b->number) ||
            (pair->body_a == b->number && pair->body_b == a->number)) {
            return true;
        }
    }
    return false;
}
