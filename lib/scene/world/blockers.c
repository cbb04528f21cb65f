/* Blockers: pairs of bodies that hold each other back, since when, and how much time they have lost. */
#include "base/error.h"
#include "scene/world/world.h"

static bool is_pair(const scene_blocker *b, scene_touching_pair bodies)
{
    return (b->bodies.body_a == bodies.body_a && b->bodies.body_b == bodies.body_b) ||
           (b->bodies.body_a == bodies.body_b && b->bodies.body_b == bodies.body_a);
}

static scene_blocker *find_blocker(scene_report *r, scene_touching_pair bodies)
{
    for (uint32_t i = 0; i < r->blocker_count; i++) {
        if (is_pair(&r->blockers[i], bodies)) {
            return &r->blockers[i];
        }
    }
    return NULL;
}

/* The deepest overlap of two bodies in the contacts of the last attempt, m. */
static double find_depth(const scene_object *s, scene_touching_pair bodies)
{
    double depth = 0.0;
    for (uint32_t i = 0; s->contacts != NULL && i < s->contacts->count; i++) {
        const contact_constraint *constraint = &s->contacts->constraints[i];
        const scene_blocker of = {.bodies = {constraint->key.body_a, constraint->key.body_b}};
        if (!constraint->is_bilateral && is_pair(&of, bodies)) {
            depth = vbss_max(-constraint->gap, depth);
        }
    }
    return depth;
}

static const char *describe_cause(vbss_scene_blocker_cause cause)
{
    static const char *const texts[] = {
        "the limit of work is exhausted", "surfaces would pass through each other",
        "the penetration is too deep", "no contact forces are found",
        "the motion does not converge"};
    return texts[cause];
}

/* A number is 0 if the body is unknown, or is the floor. */
static void log_blocker(const scene_object *s, vbss_scene_blocker_cause cause,
                        scene_touching_pair bodies)
{
    const char *text = describe_cause(cause);
    const uint32_t known = bodies.body_a != 0 ? bodies.body_a : bodies.body_b;
    if (bodies.body_a != 0 && bodies.body_b != 0 && bodies.body_a != bodies.body_b) {
        vbss_message(s->context, VBSS_LOG_WARNING, "scene: bodies %u and %u are held back: %s",
                     bodies.body_a, bodies.body_b, text);
    } else if (known != 0) {
        vbss_message(s->context, VBSS_LOG_WARNING, "scene: body %u is held back: %s", known, text);
    } else {
        vbss_message(s->context, VBSS_LOG_WARNING, "scene: bodies are held back: %s", text);
    }
}

void vbss_scene_record_blocker(scene_object *s, vbss_scene_blocker_cause cause,
                               scene_touching_pair bodies, double lost_time)
{
    scene_report *r = &s->report;
    scene_blocker *b = find_blocker(r, bodies);
    if (b == NULL) {
        if (r->blocker_count == SCENE_MAX_BLOCKERS) {
            return;
        }
        b = &r->blockers[r->blocker_count++];
        *b = (scene_blocker){.bodies = bodies, .since = r->statistics.time};
        const vbss_scene_event event = {.kind = VBSS_SCENE_EVENT_BLOCKED,
                                        .body_a = bodies.body_a,
                                        .body_b = bodies.body_b,
                                        .id = (uint32_t)cause,
                                        .value = lost_time};
        vbss_scene_add_event(s, &event, event.id);
        if (!r->is_unlogged) {
            log_blocker(s, cause, bodies);
        }
    }
    b->cause = cause;
    b->last = r->statistics.time;
    b->lost_time += lost_time;
    b->depth = find_depth(s, bodies);
}

void vbss_scene_end_blockers(scene_object *s)
{
    scene_report *r = &s->report;
    uint32_t count = 0;
    for (uint32_t i = 0; i < r->blocker_count; i++) {
        const scene_blocker *b = &r->blockers[i];
        if (r->statistics.time - b->last <= SCENE_BLOCKER_MEMORY) {
            r->blockers[count++] = *b;
            continue;
        }
        const vbss_scene_event event = {.kind = VBSS_SCENE_EVENT_UNBLOCKED,
                                        .body_a = b->bodies.body_a,
                                        .body_b = b->bodies.body_b,
                                        .id = (uint32_t)b->cause,
                                        .value = b->lost_time};
        vbss_scene_add_event(s, &event, event.id);
    }
    r->blocker_count = count;
}
