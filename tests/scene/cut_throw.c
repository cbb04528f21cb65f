#include "scene/cut_throw.h"

#include "base/elementary.h"
#include "fixtures/solver_of.h"
#include "fixtures/step_events.h"

enum { SHUTTING = 150, MAX_SHUTTING = 400 }; /* steps that blades take; what waits shuts later */

/* Hands pull on what they hold, whatever piece that is by now. */
static void follow(contact_scene *c, const scene_object *s)
{
    for (uint32_t i = 0; i < c->hand_count; i++) {
        contact_hand *hand = &c->hands[i];
        for (uint32_t k = 0; k < s->body_count; k++) {
            const scene_body *b = &s->bodies[k];
            thread_attachment *a;
            if (b->kind == SCENE_BODY_THREAD && hand->id != 0 &&
                vbss_thread_find_attachment(b->thread.thread, hand->id, &a) == VBSS_OK) {
                hand->thread = (vbss_thread *)b->thread.slot;
                hand->node = a->node;
            }
        }
    }
}

static uint32_t cuts_of_step(const contact_scene *c)
{
    const step_events events = step_events_of(c->scene);
    uint32_t cuts = 0;
    for (uint32_t i = 0; i < events.count; i++) {
        const vbss_scene_event *e = &events.of[i];
        cuts += e->kind == VBSS_SCENE_EVENT_CUT;
        assert_true(e->kind != VBSS_SCENE_EVENT_CUT || e->body_b != 0);
    }
    return cuts;
}

static vec3 middle_of_contacts(const contact_scene *c)
{
    vbss_view view;
    vec3 sum = vec3_zero();
    expect_ok(vbss_scene_get_view(c->scene, VBSS_SCENE_VIEW_CONTACT_POINTS, &view, sizeof view));
    for (uint64_t i = 0; i < view.count; i++) {
        sum = vec3_add(sum, ((const vec3 *)view.data)[i]);
    }
    assert_true(view.count > 0);
    return vec3_scale(sum, 1.0 / (double)view.count);
}

/* A knot drawn tight along x by 2 N: blades come from above, turned to close across it, and go through all of it. */
cut_outcome cut_throw(const cut_case *t, double share)
{
    cut_outcome found = {.fastest = 0.0};
    harness_memory memory;
    vbss_context *context = harness_context(&memory);
    contact_scene_options o;
    contact_scene c;
    scene_object *s;
    vbss_grasper_config config;
    vbss_grasper *tool;
    uint32_t body, cuts = 0;
    expect_ok(contact_scene_init(&o, CONTACT_SCENE_PULLED));
    o.knot.kind = t->kind;
    o.knot.length = t->length;
    o.thread.cut_capacity = 12;
    o.pull.force = 2.0;
    o.scene.thread_capacity = 16;
    o.scene.grasp_capacity = 32;
    set_call_operations(
        &o.scene,
        0); /* what the limit of a step costs; that of a call: docs/explanation/real-time.md */
    if (t->limited) {
        set_step_operations(&o.scene, (uint32_t)(share * step_operations(&o.scene)));
    } else {
        set_step_operations(&o.scene, 0);
        solver_of(&o.scene)->attempt_limit = 16;
    }
    expect_ok(contact_scene_create(context, &o, &c));
    expect_ok(vbss_scene_open(c.scene, &s));
    int steady = 0; /* steps for which it has been tight */
    for (int i = 0; i < 3000 && steady < 200; i++) {
        expect_ok(contact_scene_step(&c, 1e-3));
        steady = fabs(c.hands[0].felt - 2.0) < 0.02 ? steady + 1 : 0;
    }
    assert_int_equal(steady, 200);
    expect_ok(vbss_grasper_config_init(&config, sizeof config));
    config.kind = VBSS_GRASPER_KIND_SHEARS;
    expect_ok(vbss_grasper_create(context, &config, &tool));
    const double turned[4] = {vbss_cos(0.785398163397448), 0.0, 0.0, vbss_sin(0.785398163397448)};
    vec3 knot = middle_of_contacts(&c);
    double tip[3] = {knot.x, knot.y, knot.z + 0.025};
    expect_ok(vbss_grasper_set_target(tool, tip, turned));
    expect_ok(vbss_scene_add_grasper(c.scene, tool, &body));
    for (int i = 1; i <= 300; i++) {
        tip[2] = knot.z + 0.025 - 0.03 * i / 300.0;
        expect_ok(vbss_grasper_set_target(tool, tip, NULL));
        expect_ok(contact_scene_step(&c, 1e-3));
    }
    expect_ok(vbss_grasper_set_opening(tool, 0.0));
    vbss_grasper_state shut = {.jaw_angle = 1.0};
    for (int i = 0; i < SHUTTING || (shut.jaw_angle > 0.0 && i < MAX_SHUTTING); i++) {
        expect_ok(contact_scene_step(&c, 1e-3));
        expect_ok(vbss_grasper_get_state(tool, &shut, sizeof shut));
        cuts += cuts_of_step(&c);
        follow(&c, s);
        cut_expect_sound(s);
        for (uint32_t k = 0; k < s->body_count; k++) {
            const thread_object *u = s->bodies[k].thread.thread;
            for (uint32_t n = 0; s->bodies[k].kind == SCENE_BODY_THREAD && n < u->node_count; n++) {
                found.fastest = vbss_max(vec3_norm(u->now.v[n]), found.fastest);
            }
        }
    }
    vbss_scene_statistics statistics;
    expect_ok(vbss_scene_get_statistics(c.scene, &statistics, sizeof statistics));
    expect_near(0.0, shut.jaw_angle, 0.0);
    found.cuts = (double)cuts;
    found.clamped = (double)statistics.clamped;
    found.paused = statistics.time_paused;
    harness_context_end(context, &memory);
    return found;
}

static void expect_cut(const cut_outcome *found, const cut_case *bars)
{
    assert_true(found->cuts >= bars->min_cuts);
    assert_true(found->clamped <= bars->clamped);
    assert_true(found->fastest < 30.0); /* what 5 N let go of would reach */
}

void cut_expect_within(const cut_outcome *found, const cut_case *bars)
{
    expect_cut(found, bars);
    assert_true(found->paused <= bars->paused);
}

void cut_expect_within_known(const cut_case *bars, double paused)
{
    cut_outcome found = cut_throw(bars, 1.0);
    print_message("%.0f steps cut short, %.1f ms waited, fastest %.1f m/s\n", found.clamped,
                  1e3 * found.paused, found.fastest);
    expect_cut(&found, bars);
    expect_known_limit(bars->paused, paused, found.paused);
}
