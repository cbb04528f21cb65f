/* Algorithm 3 of VBLaST-SS: detection of punctures at the ends of steps. */
#include "baseline/puncture.h"
#include "suture/tuning.h"

void vbss_baseline_set_probe_points(const needle_object *n, pose needle, double thickness,
                                    vec3 points[3])
{
    vec3 tip = vbss_needle_point(n, 0.0);
    vec3 corner = vbss_needle_point(n, vbss_needle_vertex_arc(n, 1));
    vec3 along = vec3_unit_or(vec3_sub(corner, tip), vec3_zero());
    for (int i = 0; i < 3; i++) {
        points[i] = pose_apply(needle, vec3_add_scaled(tip, i * thickness, along));
    }
}

/* ---- crossing of a sub-segment and a triangle */

typedef struct crossing {
    double weights[3];
    bool outward;
} crossing;

/* A point in the plane counts as on its outer side; otherwise the test would miss a tip that
 * stops in the plane. */
static bool crosses(const baseline_probe *p, uint32_t t, int first, crossing *c)
{
    const uint32_t *node = p->wall->mesh.triangles[t];
    const vec3 *x = p->wall->x;
    vec3 corner = x[node[0]], e1 = vec3_sub(x[node[1]], corner), e2 = vec3_sub(x[node[2]], corner);
    vec3 normal = vec3_cross(e1, e2);
    double ahead = vec3_dot(normal, vec3_sub(p->points[first], corner));
    double behind = vec3_dot(normal, vec3_sub(p->points[first + 1], corner));
    double size = vec3_norm_squared(normal);
    if ((ahead < 0.0) == (behind < 0.0) || !(size > 0.0)) {
        return false;
    }
    vec3 at = vec3_lerp(p->points[first], p->points[first + 1], ahead / (ahead - behind));
    vec3 off = vec3_sub(at, corner);
    /* fractions of the triangle's area */
    c->weights[1] = vec3_dot(normal, vec3_cross(off, e2)) / size;
    c->weights[2] = vec3_dot(normal, vec3_cross(e1, off)) / size;
    c->weights[0] = 1.0 - c->weights[1] - c->weights[2];
    c->outward = behind < 0.0;
    return c->weights[0] >= -SUTURE_WEIGHT_ROUNDING && c->weights[1] >= -SUTURE_WEIGHT_ROUNDING &&
           c->weights[2] >= -SUTURE_WEIGHT_ROUNDING;
}

/* Returns whether two triangles are equal or share a corner, so that a tip can move from one to
 * the other. */
static bool are_beside(const drain_object *d, uint32_t a, uint32_t b)
{
    const uint32_t *one = d->mesh.triangles[a], *other = d->mesh.triangles[b];
    for (int i = 0; i < 3; i++) {
        if (one[i] == other[0] || one[i] == other[1] || one[i] == other[2]) {
            return true;
        }
    }
    return false;
}

/* ---- toggles */

static bool is_beside(const baseline_probe *p, const baseline_toggle *toggle, uint32_t t)
{
    return toggle->drain == p->drain && are_beside(p->wall, toggle->triangle, t);
}

static baseline_toggle *find_beside(const baseline_probe *p,
                                    baseline_toggle toggles[BASELINE_TOGGLES], uint32_t t)
{
    for (int i = 0; i < BASELINE_TOGGLES; i++) {
        if (is_beside(p, &toggles[i], t)) {
            return &toggles[i];
        }
    }
    return NULL;
}

/* A tip that has just made a hole, or is about to leave it, makes no second hole beside it. */
static bool is_at_hole(const baseline_probe *p, uint32_t t)
{
    for (uint32_t i = 0; i < p->hole_count; i++) {
        const suture_hole *hole = &p->holes[i];
        if (hole->id != 0 && hole->needle == p->needle && hole->wall == p->drain &&
            hole->arc < BASELINE_AT_HOLE_RATIO * p->wall->config.thickness &&
            are_beside(p->wall, hole->triangle, t)) {
            return true;
        }
    }
    return false;
}

static bool crosses_beside(const baseline_probe *p, const baseline_toggle *toggle)
{
    crossing c;
    for (uint32_t t = 0; t < p->wall->mesh.triangle_count; t++) {
        if (is_beside(p, toggle, t) && (crosses(p, t, 0, &c) || crosses(p, t, 1, &c))) {
            return true;
        }
    }
    return false;
}

bool vbss_baseline_find_puncture(const baseline_probe *probe,
                                 baseline_toggle toggles[BASELINE_TOGGLES], suture_hole *made)
{
    for (uint32_t t = 0; t < probe->wall->mesh.triangle_count; t++) {
        crossing c;
        baseline_toggle *toggle = find_beside(probe, toggles, t);
        if (toggle == NULL || !crosses(probe, t, 1, &c) || c.outward != toggle->outward) {
            continue;
        }
        *toggle = (baseline_toggle){0};
        vbss_suture_normalise_barycentric(c.weights);
        *made = (suture_hole){.needle = probe->needle,
                              .wall = probe->drain,
                              .triangle = t,
                              .barycentric = {c.weights[0], c.weights[1], c.weights[2]},
                              .is_outward = c.outward};
        return true;
    }
    return false;
}

void vbss_baseline_update_toggles(const baseline_probe *probe,
                                  baseline_toggle toggles[BASELINE_TOGGLES])
{
    for (int i = 0; i < BASELINE_TOGGLES; i++) {
        if (toggles[i].drain == probe->drain && !crosses_beside(probe, &toggles[i])) {
            toggles[i] = (baseline_toggle){0};
        }
    }
    for (uint32_t t = 0; t < probe->wall->mesh.triangle_count; t++) {
        crossing c;
        if (!crosses(probe, t, 0, &c) || find_beside(probe, toggles, t) != NULL ||
            is_at_hole(probe, t)) {
            continue;
        }
        for (int i = 0; i < BASELINE_TOGGLES; i++) {
            if (toggles[i].drain == 0) {
                toggles[i] = (baseline_toggle){probe->drain, t, c.outward};
                break;
            }
        }
    }
}
