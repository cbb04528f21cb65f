/* What a hole does to the needle in it: bears it across, rubs along. */
#include "suture/suture.h"

/* A tip that is so much further out than when it entered has left: tremor does not make a hole twice. m. */
#define LEFT 0.2e-3

vec3 vbss_hole_point(const suture_hole *hole, const drain_object *d, const vec3 *x)
{
    return vbss_drain_point(d, x, hole->triangle, hole->weights);
}

/* What it took to enter fades while the tip goes through; what was cut once stays cut. */
double vbss_hole_bound(const suture_hole *hole, const vbss_drain_config *c)
{
    double gone = hole->deepest - hole->entry;
    double left = gone < c->tip_length ? 1.0 - gone / c->tip_length : 0.0;
    double extra = greater(c->puncture_force - c->hole_force, 0.0);
    return c->hole_force + left * extra + c->hole_friction * vec3_norm(hole->across);
}

hole_lie vbss_hole_look(const suture_hole *hole, const drain_object *d, const vec3 *x,
                        const needle_object *n, pose needle)
{
    hole_lie lie = {.drain = vbss_hole_point(hole, d, x)};
    lie.arc = vbss_needle_nearest(n, pose_apply_inverse(needle, lie.drain));
    lie.needle = pose_apply(needle, vbss_needle_point(n, lie.arc));
    lie.tangent = quat_rotate(needle.orientation, vbss_needle_direction(n, lie.arc));
    return lie;
}

/* a is the needle. Toward its tip it moves when the hole goes on to larger arc lengths. */
void vbss_hole_lay_row(const suture_hole *hole, const vbss_drain_config *config,
                       const hole_lie *now, const hole_lie *before, double h, contact_row *row)
{
    uint32_t which = row->key.a % HOLE_ROWS;
    vec3 aside = vec3_any_normal(now->tangent);
    row->stiffness = config->hole_stiffness;
    row->point = now->drain;
    row->friction = 0.0; /* along its normal alone */
    row->bound = 0.0;
    if (which == HOLE_ALONG) {
        row->normal = now->tangent;
        row->slid = vec3_scale(now->tangent, now->arc - before->arc);
        row->gap = 0.0;
        row->held = vec3_scale(now->tangent, hole->held);
        row->bound = vbss_hole_bound(hole, config);
        row->beyond = config->hole_damping / h;
        row->is.state = row->is.state == CONTACT_OPEN ? CONTACT_STICK : row->is.state;
        return;
    }
    row->normal = which == 0 ? aside : vec3_cross(now->tangent, aside);
    row->slid = vec3_sub(now->needle, now->drain);
    row->gap = vec3_dot(row->normal, row->slid);
    row->is.state = CONTACT_STICK;
}

void vbss_hole_keep(suture_hole *hole, const vbss_drain_config *config, const contact_row *row)
{
    uint32_t which = row->key.a % HOLE_ROWS;
    contact_found is;
    (void)vbss_contact_next_state(row, vec3_zero(), &is);
    if (which == HOLE_ALONG) {
        double bound = vbss_hole_bound(hole, config);
        hole->held = greater(-bound, lesser(is.pressure, bound)); /* not what is viscous */
        return;
    }
    vec3 force = vec3_scale(row->normal, is.pressure);
    hole->across = which == 0 ? force : vec3_add(hole->across, force);
}

void vbss_hole_move(suture_hole *hole, double arc)
{
    hole->arc = arc;
    hole->deepest = greater(hole->deepest, arc);
}

bool vbss_hole_is_left(const suture_hole *hole, const needle_object *n)
{
    return hole->arc < hole->entry - LEFT || hole->arc > vbss_needle_length(n) - hole->entry + LEFT;
}

void vbss_hole_serialise(vbss_stream *stream, uint16_t first_tag, suture_hole *hole)
{
    uint32_t words[] = {hole->needle, hole->drain, hole->triangle, hole->outward};
    double *numbers[] = {&hole->entry, &hole->arc, &hole->deepest, &hole->held};
    vbss_stream_u32(stream, first_tag, &hole->id, 1);
    if (hole->id == 0 && stream->mode == VBSS_STREAM_READ) {
        *hole = (suture_hole){0};
    }
    if (hole->id == 0) {
        return;
    }
    vbss_stream_u32(stream, first_tag, words, sizeof words / sizeof words[0]);
    vbss_stream_f64(stream, first_tag + 1, hole->weights, 3);
    for (size_t i = 0; i < sizeof numbers / sizeof numbers[0]; i++) {
        vbss_stream_f64(stream, first_tag + 2, numbers[i], 1);
    }
    vbss_stream_f64(stream, first_tag + 3, &hole->across.x, 3);
    if (words[3] > 1) {
        vbss_stream_refuse(stream, VBSS_ERROR_CORRUPT, "no such flag");
    }
    hole->needle = words[0];
    hole->drain = words[1];
    hole->triangle = words[2];
    hole->outward = words[3] != 0;
}

bool vbss_hole_is_sound(const suture_hole *hole)
{
    double sum = 0.0;
    bool inside = true;
    for (int k = 0; k < 3; k++) {
        sum += hole->weights[k];
        inside = inside && hole->weights[k] >= 0.0;
    }
    return inside && fabs(sum - 1.0) < 1e-9 && hole->entry <= 0.0 && hole->entry >= -1.0 &&
           isfinite(hole->arc) && isfinite(hole->deepest) && hole->deepest >= hole->entry &&
           isfinite(hole->held) && vec3_is_finite(hole->across);
}
