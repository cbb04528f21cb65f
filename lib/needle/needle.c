/* Creation, motion and queries of needles. */
#include "needle/needle.h"

#include "base/api_call.h"
#include "base/check.h"
#include "base/config.h"
#include "base/error.h"
#include "base/memory.h"
#include "base/stream.h"

_Static_assert(sizeof(vbss_needle_state) == 208, "published size");
_Static_assert(sizeof(vbss_needle_mass) == 144, "published size");
_Static_assert(sizeof(vbss_needle_energies) == 32, "published size");

static const uint32_t state_sizes[] = {208, 0}, mass_sizes[] = {144, 0}, energies_sizes[] = {32, 0};
static const vbss_layout state_layout = {"vbss_needle_state", NULL, state_sizes};
static const vbss_layout mass_layout = {"vbss_needle_mass", NULL, mass_sizes};
static const vbss_layout energies_layout = {"vbss_needle_energies", NULL, energies_sizes};

/* ---- the needle's frame and that of its rigid body */

pose vbss_needle_pose(const needle_object *n)
{
    return pose_mul(n->body.now.pose, pose_inverse(n->body_frame));
}

/* From the origin of the needle's frame to its centre of mass, in the world frame. */
static vec3 frame_to_centre(const needle_object *n)
{
    vec3 in_body = quat_rotate_back(n->body_frame.orientation, n->body_frame.position);
    return quat_rotate(n->body.now.pose.orientation, in_body);
}

/* Sets position and velocities of the needle's frame; the orientation stays. */
static void set_frame_motion(needle_object *n, vec3 position, vec3 velocity, vec3 angular_velocity)
{
    vec3 arm = frame_to_centre(n);
    vbss_rigid_motion *now = &n->body.now;
    now->pose.position = vec3_add(position, arm);
    now->v = vec3_add(velocity, vec3_cross(angular_velocity, arm));
    now->w = angular_velocity;
    n->body.target_start = n->body.target_end = now->pose;
    n->generation++;
}

void vbss_needle_set_motion(needle_object *n, const vbss_rigid_motion *motion, uint32_t body_id)
{
    n->body.now = *motion;
    n->body.target_start = n->body.target_end = motion->pose;
    n->body_id = body_id;
    n->generation++;
}

/* ---- creation and destruction */

static void free_needle(vbss_context *context, void *object)
{
    vbss_release(context, object, 1, sizeof(needle_object));
}

const vbss_kind vbss_needle_kind = {"needle",    VBSS_CODE('N', 'E', 'E', 'D'), 1,
                                    free_needle, vbss_needle_serialise,         NULL};

static void init_needle(needle_object *n, const vbss_needle_config *config, quat orientation)
{
    const vbss_rigid_mass properties = vbss_needle_mass_properties(config);
    n->config = *config;
    n->body_frame = properties.frame;
    n->swage = vbss_needle_point(n, vbss_needle_length(n));
    n->body.mass = properties.mass;
    n->body.inertia = properties.inertia;
    n->body.gravity = vec3_load(config->gravity);
    n->body.drag = config->drag;
    n->body.now.pose.orientation = quat_mul(orientation, n->body_frame.orientation);
    set_frame_motion(n, vec3_load(config->position), vec3_load(config->velocity),
                     vec3_load(config->angular_velocity));
}

vbss_result vbss_needle_create(vbss_context *context, const vbss_needle_config *config,
                               vbss_needle **needle)
{
    VBSS_ENTER_WITH_RESULT(context, needle);
    if (needle == NULL) {
        VBSS_TRY(vbss_context_open(context));
        return vbss_check_pointer(context, needle, "needle");
    }
    VBSS_TRY(vbss_context_open(context));
    VBSS_TRY(vbss_context_edit(context));
    vbss_needle_config own;
    quat orientation;
    VBSS_TRY(vbss_needle_read_config(context, config, &own));
    vbss_warn_if_unlikely(context, vbss_max_abs(own.gravity, 3), VBSS_LIKELY_GRAVITY, "gravity",
                          "m/s^2", "mm/s^2");
    VBSS_TRY(vbss_read_orientation(context, own.orientation, &orientation));
    needle_object *n = vbss_allocate(context, 1, sizeof *n, "needle");
    if (n == NULL) {
        return VBSS_ERROR_OUT_OF_MEMORY;
    }
    vbss_slot *slot;
    vbss_result result = vbss_slot_create(context, &vbss_needle_kind, n, &slot);
    if (result != VBSS_OK) {
        free_needle(context, n);
        return result;
    }
    n->context = context;
    init_needle(n, &own, orientation);
    *needle = (vbss_needle *)slot;
    return VBSS_OK;
}

vbss_result vbss_needle_destroy(vbss_needle *needle)
{
    VBSS_ENTER(needle);
    return vbss_slot_destroy(needle, &vbss_needle_kind);
}

vbss_result vbss_needle_discard(vbss_needle *needle)
{
    VBSS_ENTER(needle);
    return vbss_slot_discard(needle, &vbss_needle_kind);
}

vbss_result vbss_needle_open(const vbss_needle *handle, needle_object **needle)
{
    vbss_slot *slot;
    VBSS_TRY(vbss_slot_open(handle, &vbss_needle_kind, &slot));
    *needle = slot->object;
    return VBSS_OK;
}

static vbss_result edit_unowned(vbss_needle *handle, needle_object **needle)
{
    vbss_slot *slot;
    VBSS_TRY(vbss_slot_edit_unowned(handle, &vbss_needle_kind, &slot));
    *needle = slot->object;
    return VBSS_OK;
}

/* ---- motion */

vbss_result vbss_needle_step(vbss_needle *needle, double h)
{
    VBSS_ENTER(needle);
    needle_object *n;
    VBSS_TRY(edit_unowned(needle, &n));
    VBSS_TRY(vbss_check_range(n->context, h, 1e-7, 0.1, "h"));
    const vbss_rigid_substep step = {h, 0.0, 1.0};
    vbss_rigid body = n->body;
    vbss_rigid_motion predicted;
    vbss_rigid_predict(&body, &step, &predicted);
    vbss_rigid_commit(&body, &step, &predicted, &predicted.pose);
    body.target_start = body.target_end = body.now.pose;
    if (!vbss_rigid_is_valid(&body)) {
        return vbss_fail(n->context, VBSS_ERROR_NOT_FINITE, "needle step: no finite state");
    }
    n->body = body;
    n->generation++;
    return VBSS_OK;
}

static vbss_result check_speed(vbss_context *context, const double *speed, double bound,
                               const char *name)
{
    return speed == NULL ? VBSS_OK : vbss_check_vector(context, speed, bound, name);
}

vbss_result vbss_needle_set_state(vbss_needle *needle, const double position[3],
                                  const double *orientation, const double *velocity,
                                  const double *angular_velocity)
{
    VBSS_ENTER(needle);
    needle_object *n;
    quat frame_orientation;
    VBSS_TRY(edit_unowned(needle, &n));
    VBSS_TRY(vbss_check_pointer(n->context, position, "position"));
    VBSS_TRY(vbss_check_vector(n->context, position, 1e3, "position"));
    VBSS_TRY(check_speed(n->context, velocity, 1e5, "velocity"));
    VBSS_TRY(check_speed(n->context, angular_velocity, 1e6, "angular_velocity"));
    if (orientation != NULL) {
        VBSS_TRY(vbss_read_orientation(n->context, orientation, &frame_orientation));
        n->body.now.pose.orientation = quat_mul(frame_orientation, n->body_frame.orientation);
    }
    set_frame_motion(n, vec3_load(position), velocity != NULL ? vec3_load(velocity) : vec3_zero(),
                     angular_velocity != NULL ? vec3_load(angular_velocity) : vec3_zero());
    return VBSS_OK;
}

/* ---- queries */

vbss_result vbss_needle_get_state(vbss_needle *needle, vbss_needle_state *state,
                                  uint32_t struct_size)
{
    VBSS_ENTER(needle);
    needle_object *n;
    VBSS_TRY(vbss_needle_open(needle, &n));
    vbss_needle_state own = {.struct_size = sizeof own, .body = n->body_id};
    const vbss_rigid_motion *now = &n->body.now;
    pose at = vbss_needle_pose(n);
    double end = vbss_needle_length(n);
    vec3 back = vec3_neg(vbss_needle_direction(n, end));
    pose_store(at, own.position, own.orientation);
    vec3_store(own.velocity, vec3_sub(now->v, vec3_cross(now->w, frame_to_centre(n))));
    vec3_store(own.angular_velocity, now->w);
    vec3_store(own.tip, pose_apply(at, vbss_needle_point(n, 0.0)));
    vec3_store(own.tip_direction, quat_rotate(at.orientation, vbss_needle_direction(n, 0.0)));
    vec3_store(own.swage, pose_apply(at, vbss_needle_point(n, end)));
    vec3_store(own.swage_direction, quat_rotate(at.orientation, back));
    return vbss_struct_write(n->context, &state_layout, &own, state, struct_size);
}

vbss_result vbss_needle_get_mass(vbss_needle *needle, vbss_needle_mass *mass, uint32_t struct_size)
{
    VBSS_ENTER(needle);
    static const double units[3][3] = {{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}};
    needle_object *n;
    VBSS_TRY(vbss_needle_open(needle, &n));
    vbss_needle_mass own = {.struct_size = sizeof own, .mass = n->body.mass};
    own.length = vbss_needle_length(n);
    vec3_store(own.centre, n->body_frame.position);
    vec3_store(own.inertia, n->body.inertia);
    for (int i = 0; i < 3; i++) {
        vec3_store(own.axes[i], quat_rotate(n->body_frame.orientation, vec3_load(units[i])));
    }
    return vbss_struct_write(n->context, &mass_layout, &own, mass, struct_size);
}

vbss_result vbss_needle_get_place(vbss_needle *needle, double arc_length, double position[3],
                                  double *direction)
{
    VBSS_ENTER(needle);
    needle_object *n;
    VBSS_TRY(vbss_needle_open(needle, &n));
    VBSS_TRY(vbss_check_pointer(n->context, position, "position"));
    VBSS_TRY(vbss_check_range(n->context, arc_length, -10.0, 10.0, "arc_length"));
    pose at = vbss_needle_pose(n);
    vec3_store(position, pose_apply(at, vbss_needle_point(n, arc_length)));
    if (direction != NULL) {
        vec3_store(direction, quat_rotate(at.orientation, vbss_needle_direction(n, arc_length)));
    }
    return VBSS_OK;
}

vbss_result vbss_needle_get_energies(vbss_needle *needle, vbss_needle_energies *energies,
                                     uint32_t struct_size)
{
    VBSS_ENTER(needle);
    needle_object *n;
    VBSS_TRY(vbss_needle_open(needle, &n));
    const vbss_rigid *b = &n->body;
    vec3 spin = vbss_rigid_angular_momentum(b, &b->now);
    vbss_needle_energies own = {.struct_size = sizeof own};
    own.kinetic = 0.5 * (b->mass * vec3_norm_squared(b->now.v) + vec3_dot(spin, b->now.w));
    own.gravity = -b->mass * vec3_dot(b->gravity, b->now.pose.position);
    own.total = own.kinetic + own.gravity;
    return vbss_struct_write(n->context, &energies_layout, &own, energies, struct_size);
}

/* Called only when a view is requested. */
static void fill_points(needle_object *n)
{
    pose at = vbss_needle_pose(n);
    for (uint32_t i = 0; i <= n->config.segment_count; i++) {
        n->view_points[i] = pose_apply(at, vbss_needle_point(n, vbss_needle_vertex_arc(n, i)));
    }
}

vbss_result vbss_needle_get_view(vbss_needle *needle, vbss_needle_field field, vbss_view *view,
                                 uint32_t struct_size)
{
    VBSS_ENTER(needle);
    needle_object *n;
    VBSS_TRY(vbss_needle_open(needle, &n));
    if (field != VBSS_NEEDLE_VIEW_POINTS) {
        return vbss_fail(n->context, VBSS_ERROR_OUT_OF_RANGE, "a needle has no field %d", field);
    }
    fill_points(n);
    const vbss_view own = {.type = VBSS_VIEW_TYPE_F64,
                           .components = 3,
                           .stride_bytes = sizeof n->view_points[0],
                           .count = n->config.segment_count + 1u,
                           .data = n->view_points,
                           .generation = n->generation};
    return vbss_struct_write(n->context, &vbss_view_layout, &own, view, struct_size);
}
