/* Strains: chord, arc, curvature and elongation of all segments. */
#include "thread/thread.h"

/* Mean curvature of a segment's arc, 1/m. Nodes beyond the ends have zero coefficients. */
static vec3 arc_curvature(const thread_object *t, const vec3 *x, uint32_t segment)
{
    const thread_arc *arc = &t->arcs[segment];
    vec3 curvature = arc->clamp_curvature;
    for (uint32_t k = 0; k < 4; k++) {
        if (arc->coefficient[k] != 0.0) {
            curvature = vec3_add_scaled(curvature, arc->coefficient[k], x[segment + k - 1]);
        }
    }
    return curvature;
}

void vbss_thread_compute_strains(const thread_object *t, const vec3 *x, thread_strain *strains)
{
    bool arcs = t->arcs != NULL && t->config.bending == VBSS_THREAD_BENDING_SPLINE;
    for (uint32_t i = 0; i + 1 < t->node_count; i++) {
        thread_strain *s = &strains[i];
        vec3 e = vec3_sub(x[i + 1], x[i]);
        s->chord = vec3_norm(e);
        /* Nodes that coincide have no direction. Any will do, as the stretch pushes them apart. */
        s->tangent = s->chord > 1e-150 ? vec3_scale(e, 1.0 / s->chord) : vec3_make(1.0, 0.0, 0.0);
        s->elongation = s->chord - t->rest[i];
        s->curvature = vec3_zero();
        if (arcs) {
            s->curvature = arc_curvature(t, x, i);
            s->elongation += t->arcs[i].length_coefficient * vec3_norm_squared(s->curvature);
        }
    }
}

double vbss_thread_record_stretch(thread_object *t, const double *tension)
{
    double largest_error = 0.0, largest = 0.0, compliance = 1.0 / t->config.axial_stiffness;
    for (uint32_t i = 0; i + 1 < t->node_count; i++) {
        double stretch = t->strains[i].elongation * t->inverse_rest[i];
        double error = fabs(stretch - tension[i] * compliance);
        largest = stretch > largest ? stretch : largest;
        largest_error = vbss_max_or_nan(error, largest_error);
    }
    t->statistics.last_stretch = largest;
    t->statistics.last_stretch_error = largest_error;
    return largest_error;
}
