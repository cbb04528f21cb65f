/* Internal forces at the end of the last step (implicit method): the constraint force of a
 * prescribed node, which is mass times acceleration minus all other forces, and axial forces. */
#include "thread/bending_memory.h"
#include "thread/twist.h"

static vec3 bending_force(const thread_object *t, uint32_t node)
{
    vec3 force = vec3_zero();
    for (uint32_t k = 1; k <= THREAD_CLAMP_BANDWIDTH; k++) {
        if (node + k < t->node_count) {
            vec3 e = vec3_sub(t->now.x[node + k], t->now.x[node]);
            force = vec3_add_scaled(force, -t->bending_matrix[node][k], e);
        }
        if (node >= k) {
            vec3 e = vec3_sub(t->now.x[node - k], t->now.x[node]);
            force = vec3_add_scaled(force, -t->bending_matrix[node - k][k], e);
        }
    }
    for (uint32_t c = 0; c < t->clamp_count; c++) {
        const thread_clamp *clamp = &t->clamps[c];
        uint32_t k = node + THREAD_CLAMP_BANDWIDTH - clamp->node;
        if (node + THREAD_CLAMP_BANDWIDTH >= clamp->node && k <= 2 * THREAD_CLAMP_BANDWIDTH) {
            force = vec3_add_scaled(force, -clamp->coefficient[k], clamp->direction);
        }
    }
    return force;
}

/* Force of all segments whose length depends on the node. */
static vec3 stretching_force(const thread_object *t, uint32_t node)
{
    vec3 force = vec3_zero();
    uint32_t first = node < 2 ? 0 : node - 2;
    for (uint32_t i = first; i < node + 2 && i + 1 < t->node_count; i++) {
        const thread_strain *s = &t->strains[i];
        double sign = i == node ? 1.0 : i + 1 == node ? -1.0 : 0.0;
        double curvature_coefficient =
            2.0 * t->arcs[i].length_coefficient * t->arcs[i].coefficient[node + 1 - i];
        vec3 gradient =
            vec3_sub(vec3_scale(s->tangent, sign), vec3_scale(s->curvature, curvature_coefficient));
        force = vec3_add_scaled(force, t->now.tension[i], gradient);
    }
    return force;
}

/* Force of tension, bending, rest curvature, memory and twist on a node. Tensions are more exact than
 * EA times strain. */
static vec3 internal_force(const thread_object *t, uint32_t node)
{
    vec3 force = vec3_add(bending_force(t, node), stretching_force(t, node));
    if (thread_has_memory(t)) {
        force = vec3_add(force, vbss_thread_bending_memory_force(t, node));
    }
    if (thread_has_twist(t)) {
        force = vec3_add(force, vbss_thread_twist_force(t, node));
    }
    return vec3_add(force, vbss_thread_rest_curvature_force(t, node));
}

vec3 vbss_thread_implicit_constraint_force(const thread_object *t, uint32_t node)
{
    vec3 drag = vec3_scale(t->now.v[node], -t->config.drag);
    vec3 needed = vec3_sub(vec3_sub(t->now.q[node], t->gravity), drag);
    return vec3_sub(vec3_scale(needed, t->mass[node]), internal_force(t, node));
}

/* now.tension belongs to the length of a segment alone. Bending forces of its nodes have a part
 * along it, too: about EI times the squared curvature, and many times that in a segment that is
 * much shorter than its neighbours. Internal forces balance, so those on all nodes before a
 * section add up to the force across it. */
const double *vbss_thread_implicit_axial_forces(thread_object *t)
{
    vec3 across = vec3_zero();
    vbss_thread_compute_strains(t, t->now.x, t->strains);
    for (uint32_t i = 0; i + 1 < t->node_count; i++) {
        across = vec3_add(across, internal_force(t, i));
        t->axial_forces[i] = vec3_dot(across, t->strains[i].tangent);
    }
    return t->axial_forces;
}
