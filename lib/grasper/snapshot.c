/* Serialisation of a grasper. */
#include "base/check.h"
#include "base/stream.h"
#include "grasper/grasper.h"

static void visit_config(vbss_stream *stream, const grasper_object *g)
{
    const vbss_grasper_config *c = &g->config;
    const double numbers[] = {
        c->trocar[0],
        c->trocar[1],
        c->trocar[2],
        c->driver_length,
        c->driver_radius,
        c->driver_bend,
        c->driver_opening,
        c->shears_length,
        c->shears_radius,
        c->shears_bend,
        c->shears_opening,
        c->driver_neck,
        c->shears_neck,
        c->neck_radius,
        c->shaft_length,
        c->shaft_radius,
        c->friction,
        c->closing_force,
        c->closing_angle,
        c->jaw_speed,
        c->grip_friction,
        c->grip_length,
        c->grip_stiffness,
        c->mass,
        c->stiffness,
        c->damping,
        c->turning_stiffness,
        c->turning_damping,
        c->exchange_centre[0],
        c->exchange_centre[1],
        c->exchange_centre[2],
        c->exchange_distance,
        c->baseline->grasper_stiffness,
        c->baseline->grasper_distance,
    };
    for (size_t i = 0; i < sizeof numbers / sizeof numbers[0]; i++) {
        vbss_stream_expect_f64(stream, 1, numbers[i]);
    }
    if (stream->version >= 2) {
        vbss_stream_expect_f64(stream, 4, c->needle_stiffness);
        vbss_stream_expect_f64(stream, 4, c->needle_turning_stiffness);
        vbss_stream_expect_f64(stream, 4, c->needle_torque);
        vbss_stream_expect_f64(stream, 4, c->solenoid_opening);
    }
    vbss_stream_expect(stream, 2, (uint64_t)c->method);
    vbss_stream_expect(stream, 2, (uint64_t)c->kind);
    vbss_stream_expect(stream, 2, (uint64_t)c->has_trocar);
    vbss_stream_expect(stream, 3, g->body_id); /* the scene identifies the grasper by this number */
}

static bool is_valid_kind(vbss_grasper_kind kind)
{
    return kind == VBSS_GRASPER_KIND_NEEDLE_DRIVER || kind == VBSS_GRASPER_KIND_SHEARS;
}

static bool is_unit(quat q)
{
    return fabs(quat_dot(q, q) - 1.0) < 1e-6;
}

static bool is_sound(const grasper_object *g)
{
    return is_valid_kind(g->kind) && is_valid_kind(g->commanded_kind) &&
           is_unit(g->commanded_pose.orientation) &&
           vbss_max_abs(&g->commanded_pose.position.x, 3) <= 1e3 &&
           is_unit(g->tool_pose.orientation) && g->opening >= 0.0 && g->opening <= 1.0 &&
           g->jaw_angle >= 0.0 && g->jaw_angle <= 1.6 && g->jaw_force >= 0.0 &&
           g->jaw_force <= g->config.closing_force && (g->body_id != 0 || g->grasp_count == 0) &&
           g->solenoid <= (g->needle != 0);
}

void vbss_grasper_serialise(vbss_stream *stream, void *object)
{
    grasper_object *g = object;
    visit_config(stream, g);
    vbss_stream_i32(stream, 10, &g->kind, 1);
    vbss_stream_i32(stream, 11, &g->commanded_kind, 1);
    vbss_stream_f64(stream, 12, &g->commanded_pose.position.x, 3);
    vbss_stream_f64(stream, 13, &g->commanded_pose.orientation.w, 4);
    vbss_stream_f64(stream, 14, &g->opening, 1);
    vbss_stream_f64(stream, 15, &g->jaw_angle, 1);
    vbss_stream_f64(stream, 16, &g->jaw_force, 1);
    vbss_stream_u32(stream, 20, &g->grasp_count, 1);
    if (stream->version >= 2) {
        vbss_stream_u32(stream, 27, &g->needle, 1);
        vbss_stream_u32(stream, 28, &g->drain, 1);
        vbss_stream_u32(stream, 29, &g->solenoid, 1);
    } else {
        g->needle = g->drain = g->solenoid = 0;
    }
    vbss_stream_f64(stream, 21, &g->tool_pose.position.x, 3);
    vbss_stream_f64(stream, 22, &g->tool_pose.orientation.w, 4);
    vbss_stream_f64(stream, 23, &g->velocity.x, 3);
    vbss_stream_f64(stream, 24, &g->angular_velocity.x, 3);
    vbss_stream_f64(stream, 25, &g->hand_force.x, 3);
    vbss_stream_f64(stream, 26, &g->hand_torque.x, 3);
    if (stream->mode == VBSS_STREAM_READ) {
        if (!stream->trusted && !is_sound(g)) {
            vbss_stream_refuse(stream, VBSS_ERROR_CORRUPT, "no such grasper");
        }
        vbss_grasper_update_view(g);
        g->generation++;
    }
    if (stream->trusted) { /* a way back leaves no mark */
        vbss_stream_u64(stream, 30, &g->generation, 1);
    }
}
