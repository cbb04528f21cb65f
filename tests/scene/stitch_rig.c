#include "scene/stitch_rig.h"
#include "base/elementary.h"
#include "scene/small.h"

void stitch_rig_begin(stitch_rig *r)
{
    memset(r, 0, sizeof *r);
    r->h = 1e-3;
    r->context = harness_context(&r->memory);
    expect_ok(stitch_scene_init(&r->o));
    memset(r->o.drain.gravity, 0, sizeof r->o.drain.gravity);
}

void stitch_rig_make(stitch_rig *r)
{
    expect_ok(stitch_scene_create(r->context, &r->o, &r->s));
}

void stitch_rig_end(stitch_rig *r)
{
    harness_context_end(r->context, &r->memory);
}

void stitch_rig_wait(stitch_rig *r, int steps)
{
    for (int i = 0; i < steps; i++) {
        expect_ok(vbss_scene_step(r->s.scene, r->h));
        for (int k = 0; k < 2; k++) {
            assert_true(stitch_scene_hole(&r->s, k, &r->holes[k]));
        }
    }
}

vec3 stitch_rig_outward(const stitch_rig *r, int hand)
{
    double sine, cosine;
    vbss_sincos(r->o.rise, &sine, &cosine);
    return vec3_make(0.0, sine, hand == 0 ? -cosine : cosine);
}

void stitch_rig_draw(stitch_rig *r, int hand, double distance)
{
    vec3 to = vec3_add_scaled(r->s.at[hand], distance, stitch_rig_outward(r, hand));
    expect_ok(stitch_scene_move(&r->s, hand, to));
}

void stitch_rig_pull(stitch_rig *r, int steps, double speed, double limit)
{
    for (int i = 0; i < steps; i++) {
        for (int k = 0; k < 2; k++) {
            if (stitch_scene_pull(&r->s, k) < limit) {
                stitch_rig_draw(r, k, speed * r->h);
            }
        }
        stitch_rig_wait(r, 1);
    }
}

void stitch_rig_load_tail(stitch_rig *r, double force)
{
    expect_ok(stitch_scene_let_go(&r->s, 0));
    small_draw(r->s.thread, r->s.ends[0], vec3_scale(stitch_rig_outward(r, 0), force));
}

void stitch_rig_hold_marks(stitch_rig *r)
{
    vbss_drain_places places;
    vbss_view x;
    expect_ok(vbss_drain_get_places(r->s.drain, &places, sizeof places));
    expect_ok(vbss_drain_get_view(r->s.drain, VBSS_DRAIN_VIEW_POSITIONS, &x, sizeof x));
    for (int k = 0; k < 2; k++) {
        uint32_t id;
        vbss_drain_attachment a;
        expect_ok(vbss_drain_attachment_init(&a, sizeof a));
        a.node = places.marks[k];
        memcpy(a.position, (const double *)x.data + 3 * (size_t)a.node, sizeof a.position);
        expect_ok(vbss_drain_attach(r->s.drain, &a, &id));
    }
}

vec3 stitch_rig_node(const stitch_rig *r, uint32_t i)
{
    vbss_view view;
    expect_ok(vbss_thread_get_view(r->s.thread, VBSS_THREAD_VIEW_POSITIONS, &view, sizeof view));
    return vec3_load((const double *)view.data + 3 * (size_t)i);
}

vbss_drain_gap stitch_rig_gap(const stitch_rig *r)
{
    vbss_drain_gap gap;
    expect_ok(vbss_drain_get_gap(r->s.drain, &gap, sizeof gap));
    return gap;
}

vbss_scene_statistics stitch_rig_statistics(const stitch_rig *r)
{
    vbss_scene_statistics statistics;
    expect_ok(vbss_scene_get_statistics(r->s.scene, &statistics, sizeof statistics));
    return statistics;
}
