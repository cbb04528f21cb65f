/* The state of a scene's step that waits (call.c): where it is, not what has been found. */
#include "base/stream.h"
#include "scene/scene.h"
#include "scene/step.h"

static bool is_way(const scene_object *s, const scene_way *at)
{
    const scene_part *part = &at->part;
    return part->step >= 1e-7 && part->step <= 0.1 && part->begin >= 0.0 &&
           vbss_scene_is_part(s, at->begun) && vbss_scene_is_part(s, at->size) &&
           part->begin + at->size <= 1.0 && at->before <= at->work && at->work < UINT64_MAX / 2;
}

static bool is_goal(vec3 target, vec3 force)
{
    return vec3_is_finite(target) && vec3_is_finite(force);
}

/* Where attachments go in a step that waits. */
static void visit_goals(vbss_stream *stream, scene_object *s)
{
    bool sound = true;
    for (uint32_t i = 0; i < s->place_count; i++) {
        scene_body *b = &s->bodies[i];
        thread_object *t = b->kind == BODY_THREAD ? b->thread.thread : NULL;
        drain_object *d = b->kind == BODY_DRAIN ? b->drain.drain : NULL;
        for (uint32_t k = 0; t != NULL && k < t->config.attachment_capacity; k++) {
            thread_attachment *a = &t->attachments[k];
            vbss_stream_f64(stream, 156, &a->alternate_target.x, 3);
            vbss_stream_f64(stream, 156, &a->alternate_direction.x, 3);
            vbss_stream_f64(stream, 156, &a->alternate_force.x, 3);
            bool unit = a->id == 0 || fabs(vec3_norm(a->alternate_direction) - 1.0) < 1e-6;
            sound = sound && unit && is_goal(a->alternate_target, a->alternate_force);
        }
        for (uint32_t k = 0; d != NULL && k < d->config.attachment_capacity; k++) {
            drain_attachment *a = &d->attachments[k];
            vbss_stream_f64(stream, 157, &a->alternate_target.x, 3);
            vbss_stream_f64(stream, 157, &a->alternate_force.x, 3);
            sound = sound && is_goal(a->alternate_target, a->alternate_force);
        }
    }
    if (stream->mode == VBSS_STREAM_READ && !sound) {
        vbss_stream_refuse(stream, VBSS_ERROR_CORRUPT, "no such place of an attachment");
    }
}

/* A step that waits: where it is, and how far the attempt was that is to be made again. */
static void visit_step(vbss_stream *stream, scene_object *s)
{
    scene_way *at = &s->way;
    uint32_t words[] = {at->attempts,   at->attempted, at->passed,  at->part.straight,
                        at->part.stops, s->lagging,    s->cut_count};
    double *numbers[] = {&at->part.step, &at->part.begin, &at->begun, &at->size};
    uint64_t *works[] = {&at->before, &at->work};
    vbss_stream_u32(stream, 151, words, sizeof words / sizeof words[0]);
    for (size_t i = 0; i < sizeof numbers / sizeof numbers[0]; i++) {
        vbss_stream_f64(stream, 152, numbers[i], 1);
    }
    for (size_t i = 0; i < sizeof works / sizeof works[0]; i++) {
        vbss_stream_u64(stream, 153, works[i], 1);
    }
    if (words[1] > 1 || words[3] > 1 || words[4] > 1 || words[5] > 1 || words[6] > SCENE_CUTS) {
        vbss_stream_refuse(stream, VBSS_ERROR_CORRUPT, "no such step");
        words[6] = 0;
    }
    at->attempts = words[0];
    at->attempted = words[1] != 0;
    at->passed = words[2];
    at->part.straight = words[3] != 0;
    at->part.stops = words[4] != 0;
    s->lagging = words[5] != 0;
    s->cut_count = words[6];
    for (uint32_t i = 0; i < s->cut_count; i++) {
        scene_cut *cut = &s->cuts[i];
        vbss_stream_u32(stream, 154, &cut->thread, 1);
        vbss_stream_f64(stream, 155, &cut->arc_length, 1);
        const scene_body *b = vbss_scene_body(s, cut->thread);
        if (stream->mode == VBSS_STREAM_READ &&
            (b == NULL || b->kind != BODY_THREAD || !isfinite(cut->arc_length))) {
            vbss_stream_refuse(stream, VBSS_ERROR_CORRUPT, "no such cut");
        }
    }
    for (uint32_t i = 0; i < s->config.hole_capacity; i++) {
        vbss_stream_u32(stream, 158, &s->holes_before[i].id, 1);
        vbss_stream_u32(stream, 158, &s->holes_before[i].needle, 1);
    }
    visit_goals(stream, s);
    if (stream->mode == VBSS_STREAM_READ && !stream->trusted && !is_way(s, at)) {
        vbss_stream_refuse(stream, VBSS_ERROR_CORRUPT, "no such step");
    }
}

void vbss_scene_visit_way(vbss_stream *stream, scene_object *s)
{
    scene_way *at = &s->way;
    const bool reads = stream->mode == VBSS_STREAM_READ;
    uint32_t words[] = {at->waits, at->behind, at->undivided};
    if (stream->version >= 6) {
        vbss_stream_u32(stream, 150, words, sizeof words / sizeof words[0]);
    } else {
        words[0] = words[1] = words[2] = 0;
    }
    bool may =
        !reads || s->contacts != NULL || (words[0] == 0 && words[1] == 0); /* PAPER never waits */
    if (!may || words[0] > 1 || words[1] > 2 || words[1] + words[0] > 2) {
        vbss_stream_refuse(stream, VBSS_ERROR_CORRUPT, "no such step");
        words[0] = words[1] = 0;
    }
    if (reads) {
        *at = (scene_way){.waits = words[0] != 0, .behind = words[1], .undivided = words[2]};
    }
    if (at->waits) {
        visit_step(stream, s);
    }
    if (reads) {
        vbss_scene_take_parts(s);
        s->carries_events = false;
        at->changes = vbss_scene_count_changes(s);
    }
}
