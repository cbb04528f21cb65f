/* Views of a thread: arrays, energies, momentum, statistics. */
#include "base/api_call.h"
#include "base/baseline_statistics.h"
#include "base/config.h"
#include "base/error.h"
#include "thread/bending_memory.h"
#include "thread/remesh.h"
#include "thread/twist.h"

_Static_assert(sizeof(vbss_view) == VBSS_SIZE_WITH_POINTERS(vbss_view, 32u, 1u), "published size");
_Static_assert(sizeof(vbss_thread_energies) == 64, "published size");
_Static_assert(sizeof(vbss_thread_momentum) == 88, "published size");
_Static_assert(sizeof(vbss_thread_statistics) == 160, "published size");

static const uint32_t energies_sizes[] = {48, 56, 64, 0}, momentum_sizes[] = {88, 0};
static const uint32_t statistics_sizes[] = {160, 0};
static const vbss_layout energies_layout = {"vbss_thread_energies", NULL, energies_sizes};
static const vbss_layout momentum_layout = {"vbss_thread_momentum", NULL, momentum_sizes};
static const vbss_layout statistics_layout = {"vbss_thread_statistics", NULL, statistics_sizes};

/* ---- arrays */

static void fill_lengths(thread_object *t)
{
    vbss_thread_compute_strains(t, t->now.x, t->strains);
    for (uint32_t i = 0; i + 1 < t->node_count; i++) {
        t->lengths[i] = t->rest[i] + t->strains[i].elongation;
    }
}

static void fill_curvatures(thread_object *t)
{
    for (uint32_t i = 0; i < t->node_count; i++) {
        t->curvatures[i] = vbss_thread_curvature(t, t->now.x, i);
    }
}

static void fill_sagittas(thread_object *t)
{
    for (uint32_t i = 0; i + 1 < t->node_count; i++) {
        t->sagittas[i] = vbss_thread_sagitta(t, i);
    }
}

static void fill_memory_curvatures(thread_object *t)
{
    for (uint32_t i = 0; i < t->node_count; i++) {
        const thread_bend_memory *m = &t->now.bend[2 * (size_t)i + (i + 1 < t->node_count)];
        t->memory_curvatures[0][i] = vec3_scale(m->plane, m->plastic);
        t->memory_curvatures[1][i] = vec3_scale(m->plane, m->viscous);
    }
}

static vbss_view vectors(const vec3 *data, uint64_t count)
{
    vbss_view view = {0, VBSS_VIEW_TYPE_F64, 3, sizeof *data, count, data, 0};
    return view;
}

static vbss_view scalars(const double *data, uint64_t count)
{
    vbss_view view = {0, VBSS_VIEW_TYPE_F64, 1, sizeof *data, count, data, 0};
    return view;
}

static vbss_view numbers(const uint32_t *data, uint64_t count)
{
    vbss_view view = {0, VBSS_VIEW_TYPE_U32, 1, sizeof *data, count, data, 0};
    return view;
}

static vbss_result get_field(thread_object *t, vbss_thread_field field, vbss_view *view)
{
    uint32_t n = t->node_count;
    switch (field) {
    case VBSS_THREAD_VIEW_POSITIONS:
        *view = vectors(t->now.x, n);
        return VBSS_OK;
    case VBSS_THREAD_VIEW_VELOCITIES:
        *view = vectors(t->now.v, n);
        return VBSS_OK;
    case VBSS_THREAD_VIEW_REST_LENGTHS:
        *view = scalars(t->rest, n - 1);
        return VBSS_OK;
    case VBSS_THREAD_VIEW_LENGTHS:
        fill_lengths(t);
        *view = scalars(t->lengths, n - 1);
        return VBSS_OK;
    case VBSS_THREAD_VIEW_TENSIONS: {
        const double *forces = t->method->axial_forces(t);
        *view = scalars(forces, n - 1);
        return VBSS_OK;
    }
    case VBSS_THREAD_VIEW_CURVATURES:
        fill_curvatures(t);
        *view = vectors(t->curvatures, n);
        return VBSS_OK;
    case VBSS_THREAD_VIEW_SECTIONS:
        *view = numbers(t->sections, t->section_count);
        return VBSS_OK;
    case VBSS_THREAD_VIEW_SAGITTAS:
        fill_sagittas(t);
        *view = scalars(t->sagittas, n - 1);
        return VBSS_OK;
    case VBSS_THREAD_VIEW_PLASTIC_CURVATURES:
    case VBSS_THREAD_VIEW_VISCOUS_CURVATURES: {
        const bool has_memory = thread_has_memory(t);
        if (has_memory) {
            fill_memory_curvatures(t);
        }
        *view = has_memory
                    ? vectors(t->memory_curvatures[field - VBSS_THREAD_VIEW_PLASTIC_CURVATURES], n)
                    : vectors(t->now.x, 0);
        return VBSS_OK;
    }
    case VBSS_THREAD_VIEW_TWISTS:
    case VBSS_THREAD_VIEW_MATERIAL_DIRECTORS: {
        const uint32_t count = thread_has_twist(t) ? n - 1 : 0;
        if (count > 0) {
            vbss_thread_fill_twist_views(t);
        }
        *view = field == VBSS_THREAD_VIEW_TWISTS
                    ? scalars(count > 0 ? t->twists : t->rest, count)
                    : vectors(count > 0 ? t->material_directors : t->now.x, count);
        return VBSS_OK;
    }
    default:
        return vbss_fail(t->context, VBSS_ERROR_OUT_OF_RANGE, "a thread has no field %d", field);
    }
}

vbss_result vbss_thread_get_view(vbss_thread *thread, vbss_thread_field field, vbss_view *view,
                                 uint32_t struct_size)
{
    VBSS_ENTER(thread);
    thread_object *t;
    vbss_view own;
    VBSS_TRY(vbss_thread_open(thread, &t));
    VBSS_TRY(vbss_thread_prepare_query(t));
    VBSS_TRY(get_field(t, field, &own));
    own.generation = t->generation;
    return vbss_struct_write(t->context, &vbss_view_layout, &own, view, struct_size);
}

/* ---- sums over the thread */

vbss_result vbss_thread_get_energies(vbss_thread *thread, vbss_thread_energies *energies,
                                     uint32_t struct_size)
{
    VBSS_ENTER(thread);
    thread_object *t;
    VBSS_TRY(vbss_thread_open(thread, &t));
    VBSS_TRY(vbss_thread_prepare_query(t));
    vbss_thread_energies own = {.struct_size = sizeof own};
    for (uint32_t i = 0; i < t->node_count; i++) {
        own.kinetic += 0.5 * t->mass[i] * vec3_norm_squared(t->now.v[i]);
        own.gravity -= t->mass[i] * vec3_dot(t->gravity, t->now.x[i]);
    }
    vbss_thread_compute_strains(t, t->now.x, t->strains);
    for (uint32_t i = 0; i + 1 < t->node_count; i++) {
        double elongation = t->strains[i].elongation;
        own.stretching += 0.5 * t->config.axial_stiffness / t->rest[i] * elongation * elongation;
    }
    own.bending = t->method->bending_energy(t);
    own.dissipated = t->now.dissipated_energy;
    own.total = own.kinetic + own.stretching + own.bending + own.gravity;
    if (thread_has_twist(t)) {
        own.twisting = vbss_thread_twist_energy(t);
        own.total += own.twisting;
    }
    return vbss_struct_write(t->context, &energies_layout, &own, energies, struct_size);
}

vbss_result vbss_thread_get_momentum(vbss_thread *thread, vbss_thread_momentum *momentum,
                                     uint32_t struct_size)
{
    VBSS_ENTER(thread);
    thread_object *t;
    VBSS_TRY(vbss_thread_open(thread, &t));
    VBSS_TRY(vbss_thread_prepare_query(t));
    double mass = 0.0;
    vec3 centre = vec3_zero(), linear = vec3_zero(), angular = vec3_zero();
    for (uint32_t i = 0; i < t->node_count; i++) {
        vec3 p = vec3_scale(t->now.v[i], t->mass[i]);
        mass += t->mass[i];
        centre = vec3_add_scaled(centre, t->mass[i], t->now.x[i]);
        linear = vec3_add(linear, p);
        angular = vec3_add(angular, vec3_cross(t->now.x[i], p));
    }
    vbss_thread_momentum own = {.struct_size = sizeof own, .mass = mass};
    vec3_store(own.centre, vec3_scale(centre, 1.0 / mass));
    vec3_store(own.linear, linear);
    vec3_store(own.angular, angular);
    return vbss_struct_write(t->context, &momentum_layout, &own, momentum, struct_size);
}

vbss_result vbss_thread_get_statistics(vbss_thread *thread, vbss_thread_statistics *statistics,
                                       uint32_t struct_size)
{
    VBSS_ENTER(thread);
    thread_object *t;
    VBSS_TRY(vbss_thread_open(thread, &t));
    VBSS_TRY(vbss_thread_prepare_query(t));
    vbss_thread_statistics own = t->statistics;
    own.struct_size = sizeof own;
    own.nodes = t->node_count;
    for (uint32_t i = 0; i + 1 < t->node_count; i++) {
        own.sagitta = vbss_max(vbss_thread_sagitta(t, i), own.sagitta);
    }
    return vbss_struct_write(t->context, &statistics_layout, &own, statistics, struct_size);
}

vbss_result vbss_thread_get_baseline_statistics(vbss_thread *thread,
                                                vbss_baseline_statistics *statistics,
                                                uint32_t struct_size)
{
    VBSS_ENTER(thread);
    thread_object *t;
    VBSS_TRY(vbss_thread_open(thread, &t));
    return vbss_baseline_write_statistics(t->context, t->method->baseline_statistics(t), statistics,
                                          struct_size);
}
