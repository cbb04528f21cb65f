/* What a hole does to the suture in it: bears it across, rubs along. */
#include "base/stream.h"
#include "suture/suture.h"

/* From this version of the stream on threads are in holes. */
enum { THREADS = 5 };

vec3 vbss_hole_point(const suture_hole *hole, const drain_object *d, const vec3 *x)
{
    return vbss_drain_point(d, x, hole->triangle, hole->weights);
}

/* What it took to enter fades while the tip goes through; what was cut once stays cut. */
static double least_of_needle(const suture_hole *hole, const vbss_drain_config *c)
{
    double gone = hole->deepest - hole->entry;
    double left = gone < c->tip_length ? 1.0 - gone / c->tip_length : 0.0;
    return c->hole_force + left * vbss_max(c->puncture_force - c->hole_force, 0.0);
}

/* How far from the needle's to the thread's, over the length of a tip: nothing jumps. */
static double share_of_thread(const suture_line *line, const vbss_drain_config *config, double far)
{
    if (line->needle != NULL && far <= 0.0) {
        return 0.0;
    }
    return line->needle == NULL || far >= config->tip_length ? 1.0 : far / config->tip_length;
}

/* What the needle's end bends, the first two segments, is no rope round a post: if the thread leaves it askew, that would bear
 * ten times as much along as across, of which neither sticking nor sliding comes. There it rubs as the needle does. */
enum { BENT_BY_NEEDLE = 2 };

hole_bound vbss_hole_bound(const suture_hole *hole, const vbss_drain_config *config,
                           const suture_line *line, const suture_place *place)
{
    hole_bound b = {least_of_needle(hole, config), {config->hole_friction, config->hole_friction}};
    double behind = place->arc - line->swage, grip[2];
    if (line->thread == NULL || (line->needle != NULL && behind <= 0.0)) {
        return b;
    }
    const uint32_t last = line->thread->node_count - 1;
    const uint32_t end = last < BENT_BY_NEEDLE ? last : BENT_BY_NEEDLE;
    const double bent = vbss_thread_arc_length(line->thread, end);
    const double rope = share_of_thread(line, config, behind - bent);
    b.least += share_of_thread(line, config, behind) * (config->thread_force - b.least);
    vbss_suture_grip(line, place, config->hole_friction, grip);
    for (int k = 0; k < 2; k++) {
        b.grip[k] += rope * (grip[k] - b.grip[k]);
    }
    return b;
}

/* Toward the tip the suture moves when the hole goes on to larger arc lengths. */
void vbss_hole_lay_row(const suture_hole *hole, const vbss_drain_config *config,
                       const suture_place *now, vec3 drain, double h, contact_constraint *row)
{
    row->normal = now->tangent;
    row->curvature = now->turn;
    row->relative_displacement = vec3_sub(now->point, drain);
    row->relative_displacement =
        vec3_add_scaled(row->relative_displacement, now->arc - row->start_arc_length, now->tangent);
    row->gap = 0.0;
    row->point = drain;
    row->previous_force = vec3_scale(now->tangent, hole->held);
    row->stiffness = config->hole_stiffness;
    row->viscous_stiffness = config->hole_damping / h;
    row->friction = 0.0; /* that of a sleeve */
}

void vbss_hole_move(suture_hole *hole, double arc)
{
    hole->arc = arc;
    hole->deepest = vbss_max(hole->deepest, arc);
}

void vbss_hole_keep(suture_hole *hole, const contact_constraint *row)
{
    contact_solution is;
    (void)vbss_contact_update_solution(row, vec3_zero(), &is);
    hole->held = is.normal_force;
    hole->across = is.tangential_force;
}

void vbss_hole_serialise(vbss_stream *stream, uint16_t first_tag, suture_hole *hole)
{
    uint32_t words[] = {hole->needle, hole->drain, hole->triangle, hole->outward, hole->thread};
    uint32_t count = stream->version >= THREADS ? 5 : 4;
    double *numbers[] = {&hole->entry, &hole->arc, &hole->deepest, &hole->held};
    vbss_stream_u32(stream, first_tag, &hole->id, 1);
    if (hole->id == 0 && stream->mode == VBSS_STREAM_READ) {
        *hole = (suture_hole){0};
    }
    if (hole->id == 0) {
        return;
    }
    if (stream->mode == VBSS_STREAM_READ && count == 4) {
        words[4] = 0; /* what is read into may have been in a thread */
    }
    vbss_stream_u32(stream, first_tag, words, count);
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
    hole->thread = words[4];
}

bool vbss_hole_is_sound(const suture_hole *hole)
{
    double sum = 0.0;
    bool inside = true;
    for (int k = 0; k < 3; k++) {
        sum += hole->weights[k];
        inside = inside && hole->weights[k] >= 0.0;
    }
    return (hole->needle == 0) != (hole->thread == 0) && inside && fabs(sum - 1.0) < 1e-9 &&
           hole->entry <= 0.0 && hole->entry >= -1.0 && isfinite(hole->arc) &&
           isfinite(hole->deepest) && hole->deepest >= hole->entry && isfinite(hole->held) &&
           vec3_is_finite(hole->across);
}
