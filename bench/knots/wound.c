#include "knots/wound.h"

#include <stdlib.h>

#include "base/elementary.h"
#include "base/linear.h"
#include "base/random.h"

#define TURN 6.28318530717958648
#define TURNS 2.5
#define RADIUS 2.6e-3
enum { TOOLS = 2 };

static vbss_knot_input *inputs;
static vbss_knot_tool *tools;
static double (*points)[3];

void wound_end(void)
{
    free(inputs);
    free(tools);
    free(points);
    inputs = NULL;
    tools = NULL;
    points = NULL;
}

/* The tail comes from the tissue, three fifths of the segments wind about the first tool, and the rest leads to the second, which
 * holds the needle; both come from above. */
static vec3 point_of(double share, double sway)
{
    double sine, cosine;
    if (share < 0.2) {
        return vec3_make(RADIUS + 0.15 * (0.2 - share), 1e-3 * sway, 0.004 - 0.2 * (0.2 - share));
    }
    if (share < 0.8) {
        double along = (share - 0.2) / 0.6;
        vbss_sincos(TURN * TURNS * along, &sine, &cosine);
        double r = RADIUS * (1.0 + 0.1 * sway * along);
        return vec3_make(r * cosine, r * sine, 0.004 + 0.02 * along);
    }
    vec3 leaves = point_of(0.8 - 1e-12, sway), needle = vec3_make(0.03, 0.01, 0.01);
    return vec3_lerp(leaves, needle, (share - 0.8) / 0.2);
}

static void set_tool(vbss_knot_tool *tool, vec3 tip, vec3 handle, quat turn)
{
    *tool = (vbss_knot_tool){.point_count = 3, .radius = {2e-3, 1.5e-3}};
    vec3_store(tool->axis[0], quat_rotate(turn, handle));
    vec3_store(tool->axis[1], quat_rotate(turn, vec3_lerp(tip, handle, 0.1)));
    vec3_store(tool->axis[2], quat_rotate(turn, tip));
}

static void show(uint32_t i, uint32_t segments)
{
    vbss_random random;
    vbss_random_seed(&random, i, 32);
    double q[4], sway = vbss_random_uniform(&random);
    for (int k = 0; k < 4; k++) {
        q[k] = vbss_random_normal(&random);
    }
    quat turn = quat_unit(quat_make(q[0], q[1], q[2], q[3]));
    double(*x)[3] = points + (size_t)i * (segments + 1);
    for (uint32_t k = 0; k <= segments; k++) {
        vec3_store(x[k], quat_rotate(turn, point_of((double)k / segments, sway)));
    }
    vbss_knot_tool *own = tools + (size_t)i * TOOLS;
    set_tool(&own[0], vec3_zero(), vec3_make(0.0, 0.0, 0.3), turn);
    set_tool(&own[1], vec3_make(0.03, 0.01, 0.01), vec3_make(0.2, 0.05, 0.25), turn);
    own[1].held = VBSS_KNOT_HELD_NEEDLE;
    (void)vbss_knot_input_init(&inputs[i], sizeof inputs[i]);
    inputs[i].points = x[0];
    inputs[i].point_count = segments + 1;
    inputs[i].tools = own;
    inputs[i].tool_count = TOOLS;
}

const vbss_knot_input *wound_inputs(uint32_t segments, uint32_t count)
{
    wound_end();
    inputs = calloc(count, sizeof *inputs);
    tools = calloc((size_t)count * TOOLS, sizeof *tools);
    points = calloc((size_t)count * (segments + 1), sizeof *points);
    if (inputs == NULL || tools == NULL || points == NULL) {
        wound_end();
        return NULL;
    }
    for (uint32_t i = 0; i < count; i++) {
        show(i, segments);
    }
    return inputs;
}
