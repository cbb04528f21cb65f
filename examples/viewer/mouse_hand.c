#include "mouse_hand.h"

#include <math.h>
#include <string.h>

#include "throw/hand.h"

#define LAG \
    0.04 /* s, within which most of a movement is made: wheels and slow frames come in jerks */
#define FASTEST 0.25  /* m/s, of a shift */
#define SWIFTEST 4.0  /* rad/s, of a turn */
#define REACH 0.15    /* m, of the tool from the middle, each way */
#define HALF_OPEN 0.5 /* of a handle */
#define PRESS 8.0     /* N, on a tool: no mouse feels that something holds it back */

enum { SHIFT = 0, TURN = 1 };

/* ---- the adapter */

/* The part of a movement that is made in so much time. */
static void take(mouse_hand *m, int motion_kind, double h, double motion[3])
{
    const double *rest = m->pending[motion_kind];
    const vbss_mapping_config *c = &m->mapping;
    const double unit = motion_kind == SHIFT ? c->mouse_metres : c->mouse_radians;
    const double notch = motion_kind == SHIFT ? c->mouse_depth : c->mouse_roll;
    const double size = sqrt((rest[0] * rest[0] + rest[1] * rest[1]) * unit * unit +
                             rest[2] * rest[2] * notch * notch);
    const double largest = (motion_kind == SHIFT ? FASTEST : SWIFTEST) * h;
    double share = fmin(1.0, h / LAG);
    share = size * share > largest ? largest / size : share;
    for (int i = 0; i < 3; i++) {
        motion[i] = share * rest[i];
        m->pending[motion_kind][i] -= motion[i];
    }
}

/* Wheels roll a tool about its own axis, wherever one looks from. */
static vbss_result roll(mouse_hand *m, double notches, uint32_t buttons)
{
    const double motion[3] = {0.0, 0.0, notches};
    vbss_mapping_config own = m->mapping;
    v_store(own.right, hand_rotate(m->sample.orientation, v3(1.0, 0.0, 0.0)));
    v_store(own.up, hand_rotate(m->sample.orientation, v3(0.0, 1.0, 0.0)));
    return vbss_mapping_mouse(&own, motion, buttons, 0.0, &m->sample);
}

/* Speeds are those of the mapping, times the grain; jaws are the mouse's. */
static vbss_result go_by_pad(mouse_hand *m, double h)
{
    vbss_mapping_config screen = m->mapping, own;
    double shift[6] = {0.0}, spin[6] = {0.0};
    memcpy(shift, m->pull, 5 * sizeof *shift);
    spin[5] = m->pull[5];
    screen.pad_speed *= m->grain;
    screen.pad_turning *= m->grain;
    own = screen;
    v_store(own.right, hand_rotate(m->sample.orientation, v3(1.0, 0.0, 0.0)));
    v_store(own.up, hand_rotate(m->sample.orientation, v3(0.0, 1.0, 0.0)));
    TRY(vbss_mapping_gamepad(&screen, shift, m->sample.jaw, h, &m->sample));
    return vbss_mapping_gamepad(&own, spin, m->sample.jaw, h, &m->sample);
}

/* A hand goes no farther away from a tool that something holds back. */
static vbss_result hold_back(mouse_hand *m, vec before)
{
    vbss_grasper_state tool;
    TRY(vbss_grasper_get_state(m->tool, &tool, sizeof tool));
    const vec lead = v_sub(v_load(tool.target_position), v_load(tool.position));
    const vec step = v_sub(v_load(m->sample.position), before);
    if (v_length(v_load(tool.hand_force)) > PRESS && v_dot(step, lead) > 0.0) {
        v_store(m->sample.position, v_add(before, v_across(step, v_unit(lead))));
    }
    return VBSS_OK;
}

static vbss_result read_hand(void *user, double now, vbss_device_sample *sample)
{
    mouse_hand *m = user;
    const double h = fmax(0.0, fmin(now - m->time, LAG));
    const uint32_t jaws = m->closes ? VBSS_MAPPING_MOUSE_CLOSE : 0;
    const vec before = v_load(m->sample.position);
    double motion[3];
    take(m, TURN, h, motion);
    TRY(roll(m, motion[2], jaws | VBSS_MAPPING_MOUSE_TURN));
    motion[2] = 0.0;
    TRY(vbss_mapping_mouse(&m->mapping, motion, jaws | VBSS_MAPPING_MOUSE_TURN, 0.0, &m->sample));
    take(m, SHIFT, h, motion);
    TRY(vbss_mapping_mouse(&m->mapping, motion, jaws, h, &m->sample));
    TRY(go_by_pad(m, h));
    TRY(hold_back(m, before));
    m->time = now;
    m->sample.time = now;
    const uint32_t size = sample->struct_size;
    memcpy(sample, &m->sample, size < sizeof m->sample ? size : sizeof m->sample);
    sample->struct_size = size;
    return VBSS_OK;
}

/* ---- made */

static vbss_result begin_at(mouse_hand *m, vbss_grasper *tool)
{
    vbss_grasper_state state;
    TRY(vbss_grasper_get_state(tool, &state, sizeof state));
    TRY(vbss_device_sample_init(&m->sample, sizeof m->sample));
    memcpy(m->sample.position, state.target_position, sizeof state.target_position);
    memcpy(m->sample.orientation, state.target_orientation, sizeof state.target_orientation);
    m->sample.jaw = state.opening;
    m->sample.valid = VBSS_DEVICE_HAS_POSITION | VBSS_DEVICE_HAS_ORIENTATION | VBSS_DEVICE_HAS_JAW;
    m->closes = state.opening < HALF_OPEN;
    m->tool = tool;
    m->body = state.body;
    return VBSS_OK;
}

vbss_result mouse_hand_create(mouse_hand *m, vbss_context *context, vbss_grasper *tool)
{
    vbss_device_adapter adapter;
    vbss_device_config c;
    vbss_device_calibration space;
    memset(m, 0, sizeof *m);
    TRY(vbss_mapping_config_init(&m->mapping, sizeof m->mapping));
    TRY(begin_at(m, tool));
    TRY(vbss_device_adapter_init(&adapter, sizeof adapter));
    adapter.name = "mouse";
    adapter.user = m;
    adapter.read = read_hand;
    TRY(vbss_device_calibration_init(&space, sizeof space));
    for (int i = 0; i < 3; i++) {
        m->mapping.low[i] =
            -1.0; /* of the desk, which is large: the clutch is for the tool's sake */
        m->mapping.high[i] = 1.0;
        space.workspace_low[i] = -REACH;
        space.workspace_high[i] = REACH;
    }
    TRY(vbss_device_config_init(&c, sizeof c));
    c.clock = VBSS_DEVICE_CLOCK_SHARED;
    c.calibration = &space;
    return vbss_device_create(context, &adapter, NULL, &c, &m->device);
}

/* ---- led */

static vec vec_of_point(point3 p)
{
    return v3((double)p.x, (double)p.y, (double)p.z);
}

/* The library wants right and up as unit vectors to 1e-6, the camera has them in floats. */
void mouse_hand_set_camera(mouse_hand *m, const camera *c)
{
    const camera_view view = camera_get_view(c, 1.0F);
    vec right = v_unit(vec_of_point(view.right)),
        up = v_unit(v_across(vec_of_point(view.up), right));
    v_store(m->mapping.right, right);
    v_store(m->mapping.up, up);
}

void mouse_hand_move(mouse_hand *m, bool turns, double right, double up, double away)
{
    double *rest = m->pending[turns ? TURN : SHIFT];
    rest[0] += right;
    rest[1] += up;
    rest[2] += away;
}

void mouse_hand_pull(mouse_hand *m, const double axes[6], double grain)
{
    memcpy(m->pull, axes, sizeof m->pull);
    m->grain = grain;
}

vbss_result mouse_hand_clutch(mouse_hand *m, bool held)
{
    m->clutched = held;
    return vbss_device_set_clutch(m->device, held);
}

void mouse_hand_centre(mouse_hand *m)
{
    for (int i = 0; i < 3 && !m->clutched; i++) {
        m->sample.position[i] -= m->in.position[i];
        m->in.position[i] = 0.0;
    }
}

vbss_result mouse_hand_read(mouse_hand *m, double now)
{
    return vbss_device_read(m->device, now, &m->in, sizeof m->in);
}
