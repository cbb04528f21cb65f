#include "scene/tools_rig.h"
#include "fixtures/scene_build.h"

void tools_begin(tools_rig *r)
{
    memset(r, 0, sizeof *r);
    small_begin(&r->s);
    expect_ok(vbss_grasper_config_init(&r->config, sizeof r->config));
    r->s.config.capsule_capacity = 32;
}

void tools_begin_scene(tools_rig *r)
{
    tools_begin(r);
    small_create(&r->s);
}

void tools_end(tools_rig *r)
{
    small_end(&r->s);
}

/* ---- what is in it */

uint32_t tools_add_turned(tools_rig *r, vec3 tip, quat turn)
{
    const scene_build_hand hand = {tip, turn, 1.0};
    uint32_t tool = r->count++;
    assert_true(tool < TOOLS_MAX);
    r->config.method = r->s.config.method;
    expect_ok(scene_build_grasper(r->s.context, r->s.scene, &r->config, &hand, &r->tools[tool],
                                  &r->bodies[tool]));
    return tool;
}

uint32_t tools_add(tools_rig *r, vec3 tip)
{
    return tools_add_turned(r, tip, quat_identity());
}

void tools_thread(tools_rig *r, tools_ends ends, double aside)
{
    small *s = &r->s;
    s->thread.method = s->config.method;
    r->body = small_thread(s, vec3_make(aside, -0.015, 0.0), vec3_make(aside, 0.015, 0.0),
                           TOOLS_SEGMENTS, &r->thread);
    if (ends != TOOLS_NEITHER) {
        r->pins[0] = small_pin(s, r->body, 0, 0);
    }
    if (ends == TOOLS_BOTH) {
        r->pins[1] = small_pin(s, r->body, TOOLS_NODES - 1, 0);
    }
}

/* ---- what hands do */

void tools_move(tools_rig *r, uint32_t tool, vec3 tip)
{
    double position[3];
    vec3_store(position, tip);
    expect_ok(vbss_grasper_set_target(r->tools[tool], position, NULL));
}

void tools_open(tools_rig *r, uint32_t tool, double opening)
{
    expect_ok(vbss_grasper_set_opening(r->tools[tool], opening));
}

void tools_steps(tools_rig *r, uint32_t count)
{
    small_steps(&r->s, count, 1e-3);
}

void tools_move_along(tools_rig *r, uint32_t tool, vec3 from, vec3 to, uint32_t steps)
{
    for (uint32_t i = 1; i <= steps; i++) {
        tools_move(r, tool, vec3_lerp(from, to, (double)i / steps));
        tools_steps(r, 1);
    }
}

void tools_close(tools_rig *r, uint32_t tool)
{
    tools_open(r, tool, 0.0);
    tools_steps(r, 300);
}

/* ---- looks */

vbss_grasper_state tools_state(const tools_rig *r, uint32_t tool)
{
    vbss_grasper_state state;
    expect_ok(vbss_grasper_get_state(r->tools[tool], &state, sizeof state));
    return state;
}

vec3 tools_hand_force(const tools_rig *r, uint32_t tool)
{
    vbss_grasper_state state = tools_state(r, tool);
    return vec3_load(state.hand_force);
}

vbss_scene_grasp tools_grasp(const tools_rig *r, uint32_t tool, uint32_t index)
{
    vbss_scene_grasp grasp;
    expect_ok(vbss_scene_get_grasp(r->s.scene, r->bodies[tool], index, &grasp, sizeof grasp));
    return grasp;
}

uint32_t tools_happened(const tools_rig *r, vbss_scene_event_kind kind, vbss_scene_event *event)
{
    return small_events(&r->s, kind, event);
}

static vec3 field_of(const tools_rig *r, vbss_thread_field field, uint32_t node)
{
    vbss_view view;
    double v[3];
    expect_ok(vbss_thread_get_view(r->thread, field, &view, sizeof view));
    assert_true(node < view.count);
    memcpy(v, (const char *)view.data + (size_t)node * view.stride_bytes, sizeof v);
    return vec3_load(v);
}

vec3 tools_node(const tools_rig *r, uint32_t node)
{
    return field_of(r, VBSS_THREAD_VIEW_POSITIONS, node);
}

vec3 tools_node_velocity(const tools_rig *r, uint32_t node)
{
    return field_of(r, VBSS_THREAD_VIEW_VELOCITIES, node);
}

double tools_length(const tools_rig *r)
{
    vbss_view view;
    double sum = 0.0;
    expect_ok(vbss_thread_get_view(r->thread, VBSS_THREAD_VIEW_REST_LENGTHS, &view, sizeof view));
    for (uint64_t i = 0; i < view.count; i++) {
        double length;
        memcpy(&length, (const char *)view.data + i * view.stride_bytes, sizeof length);
        sum += length;
    }
    return sum;
}

vec3 tools_pin_force(const tools_rig *r, uint32_t end)
{
    const scene_object *s = small_object(&r->s);
    vbss_thread_reaction reaction;
    for (uint32_t i = 0; i < s->config.pin_capacity; i++) {
        if (s->pins[i].id != 0 && s->pins[i].id == r->pins[end]) {
            expect_ok(vbss_thread_get_reaction(r->thread, s->pins[i].attachment, &reaction,
                                               sizeof reaction));
            return vec3_load(reaction.force);
        }
    }
    fail_msg("the thread's end is not pinned");
    return vec3_zero();
}
