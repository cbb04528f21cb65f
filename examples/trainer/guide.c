#include "trainer/guide.h"

#include <math.h>
#include <string.h>

#include "throw/vec.h"

#define MIN_DISPLACEMENT 0.02 /* m, of a motion that tells an axis */
#define STRAIGHT 2.0          /* so much more than along the others */
#define MIN_REACH 0.04        /* m, along each axis */
#define MIN_SPAN 0.05         /* V of a handle: five steps of an 11-bit converter */
#define HIGHEST 10.0          /* V */
#define MEAN 0.05             /* share of a new sample in the handle's mean */

static const char *const questions[] = {
    "Hold the handle in the middle of its space.",
    "Move it straight to the right, by more than 2 cm.",
    "Back to the middle, then straight up.",
    "Back to the middle, then straight toward you.",
    "Point the instrument's tip straight down, its jaws opening to the left and right.",
    "Move it along all borders of the space you will work in.",
    "Close the handle firmly, and keep it closed.",
    "Open the handle, and keep it open.",
    "Done."};

const char *guide_ask(const guide *g)
{
    return questions[g->step];
}

vbss_result guide_plain(vbss_device_calibration *c)
{
    vbss_result result = vbss_device_calibration_init(c, sizeof *c);
    c->jaw_closed = -HIGHEST;
    c->jaw_open = HIGHEST;
    return result;
}

vbss_result guide_begin(guide *g, bool arm, bool handle, const vbss_device_calibration *from)
{
    memset(g, 0, sizeof *g);
    g->arm = arm;
    g->handle = handle;
    g->step = arm ? GUIDE_REST : handle ? GUIDE_CLOSE : GUIDE_DONE;
    g->found = *from;
    return VBSS_OK;
}

void guide_see(guide *g, const vbss_device_input *in)
{
    if (g->arm && in->status != VBSS_DEVICE_STATUS_READY) {
        return;
    }
    for (int i = 0; i < 3; i++) {
        g->low[i] = g->seen ? smaller(g->low[i], in->position[i]) : in->position[i];
        g->high[i] = g->seen ? larger(g->high[i], in->position[i]) : in->position[i];
    }
    memcpy(g->position, in->position, sizeof g->position);
    memcpy(g->orientation, in->orientation, sizeof g->orientation);
    g->raw += (g->seen ? MEAN : 1.0) * (in->jaw_raw - g->raw);
    g->seen = true;
}

/* ---- what it means */

/* The device's axis along which the hand went from its rest, counted from 1; negative: against it. */
static const char *find_axis(const guide *g, int32_t *axis)
{
    double displacement[3], largest = 0.0, next = 0.0;
    for (int i = 0; i < 3; i++) {
        displacement[i] = g->position[i] - g->rest[i];
        if (fabs(displacement[i]) > largest) {
            next = largest;
            largest = fabs(displacement[i]);
            *axis = displacement[i] > 0.0 ? i + 1 : -(i + 1);
        } else {
            next = larger(next, fabs(displacement[i]));
        }
    }
    return largest < MIN_DISPLACEMENT  ? "that was too short"
           : largest < STRAIGHT * next ? "that was not straight"
                                       : NULL;
}

/* World axes: x right, y away from who trains, z up. */
static const char *take_axis(guide *g)
{
    int32_t axis = 0, *axes = g->found.axes;
    const char *why = find_axis(g, &axis);
    if (why != NULL) {
        return why;
    }
    if (g->step == GUIDE_RIGHT) {
        axes[0] = axis;
        axes[1] = axes[2] = 0;
        return NULL;
    }
    for (int i = 0; i < 3; i++) {
        if (axis == axes[i] || axis == -axes[i]) {
            return "that was along an axis that is known already";
        }
    }
    axes[g->step == GUIDE_UP ? 2 : 1] = g->step == GUIDE_UP ? axis : -axis;
    return NULL;
}

static void to_world(const int32_t axes[3], const double v[3], double out[3])
{
    for (int i = 0; i < 3; i++) {
        int from = (axes[i] < 0 ? -axes[i] : axes[i]) - 1;
        out[i] = axes[i] < 0 ? -v[from] : v[from];
    }
}

/* -1: the axes mirror. */
static double handedness(const int32_t axes[3])
{
    double m[3][3];
    for (int k = 0; k < 3; k++) {
        double e[3] = {0.0, 0.0, 0.0};
        e[k] = 1.0;
        to_world(axes, e, m[k]);
    }
    return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
           m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
           m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}

/* The tool's own axes are the world's now: what turns the handle there is undone. */
static void take_mount(guide *g)
{
    double axis[3], sign = handedness(g->found.axes);
    to_world(g->found.axes, g->orientation + 1, axis);
    g->found.mount[0] = g->orientation[0];
    for (int i = 0; i < 3; i++) {
        g->found.mount[i + 1] = -sign * axis[i];
    }
}

static const char *take_reach(guide *g)
{
    double a[3], b[3];
    to_world(g->found.axes, g->low, a);
    to_world(g->found.axes, g->high, b);
    for (int i = 0; i < 3; i++) {
        if (fabs(a[i] - b[i]) < MIN_REACH) {
            return "that was less than 4 cm along one axis";
        }
    }
    g->found.scale = 1.0;
    for (int i = 0; i < 3; i++) {
        g->found.offset[i] = 0.0;
        g->found.workspace_low[i] = smaller(a[i], b[i]);
        g->found.workspace_high[i] = larger(a[i], b[i]);
    }
    return NULL;
}

static const char *take_open(guide *g)
{
    if (fabs(g->raw - g->closed) < MIN_SPAN) {
        return "the sensor says the same open and closed: see the wiring";
    }
    g->found.jaw_closed = g->closed;
    g->found.jaw_open = g->raw;
    return NULL;
}

static const char *take(guide *g)
{
    switch (g->step) {
    case GUIDE_REST:
        memcpy(g->rest, g->position, sizeof g->rest);
        return NULL;
    case GUIDE_RIGHT:
    case GUIDE_UP:
    case GUIDE_TOWARD:
        return take_axis(g);
    case GUIDE_POINT:
        take_mount(g);
        return NULL;
    case GUIDE_REACH:
        return take_reach(g);
    case GUIDE_CLOSE:
        g->closed = g->raw;
        return NULL;
    case GUIDE_OPEN:
        return take_open(g);
    case GUIDE_DONE:
        break;
    }
    return NULL;
}

const char *guide_next(guide *g)
{
    const char *why = g->seen ? take(g) : "the device tells nothing";
    if (why == NULL && g->step != GUIDE_DONE) {
        g->step = g->step == GUIDE_REACH && !g->handle ? GUIDE_DONE : (guide_step)(g->step + 1);
    }
    g->seen = false;
    return why;
}

void guide_centre(guide *g, const double middle[3])
{
    for (int i = 0; g->arm && i < 3; i++) {
        double at = 0.5 * (g->found.workspace_low[i] + g->found.workspace_high[i]);
        g->found.offset[i] = middle[i] - at;
        g->found.workspace_low[i] += g->found.offset[i];
        g->found.workspace_high[i] += g->found.offset[i];
    }
}
