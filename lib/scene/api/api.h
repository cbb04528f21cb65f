/* The handles of scenes. Only the exported functions in this folder open a handle or edit a
 * scene. */
#ifndef VBSS_SCENE_API_H
#define VBSS_SCENE_API_H

#include "scene/world/scene_data.h"

/* The kind of a scene's handle: its name, its code and version in snapshots, and how it is freed
 * and serialised. Defined in create.c. */
extern const vbss_kind vbss_scene_kind;

/* ---- solver_options.c */

/* Checks the options at `given`, or takes the defaults if it is NULL, and copies them to *own. */
vbss_result vbss_solver_options_read(vbss_context *context, const vbss_solver_options *given,
                                     vbss_solver_options *own);

/* Checks the budgets, us, and the speed of the core, operations per us. */
vbss_result vbss_solver_options_check_budgets(vbss_context *context, double step_budget_us,
                                              double call_budget_us, double operations_per_us);

/* ---- reference_scene.c */

/* A small fixed scene that measures the speed of the core: a rod presses on a drain, and a thread
 * lies on the floor. */
typedef struct scene_reference {
    vbss_scene *scene;
    vbss_thread *thread;
    vbss_drain *drain;
    uint32_t rod; /* number of the rod in the scene */
    uint32_t steps;
} scene_reference;

/* Creates the scene and lets its motion become periodic. Whatever it returns,
 * vbss_scene_destroy_reference must follow. */
vbss_result vbss_scene_create_reference(vbss_context *context, scene_reference *reference);

/* Makes one step. SCENE_REFERENCE_PERIOD steps are a period of the motion. */
vbss_result vbss_scene_step_reference(scene_reference *reference);
enum { SCENE_REFERENCE_PERIOD = 4 };

/* Operations of all steps so far. */
uint64_t vbss_scene_count_reference_operations(const scene_reference *reference);

void vbss_scene_destroy_reference(scene_reference *reference);

/* ---- handle.c */

/* Opens a scene for reading. Sets the error and returns VBSS_ERROR_INVALID_HANDLE if the handle
 * is not that of a living scene. */
vbss_result vbss_scene_open(const vbss_scene *handle, scene_object **scene);

/* Opens a scene for a change. Returns VBSS_ERROR_INVALID_HANDLE as vbss_scene_open does, or
 * VBSS_ERROR_BUSY inside a callback of the context. */
vbss_result vbss_scene_open_mutable(vbss_scene *handle, scene_object **scene);

/* ---- loads_api.c */

/* Sets the error and returns VBSS_ERROR_INCOMPATIBLE if hosts cannot change the scene at run time:
 * its method is the baseline's. */
vbss_result vbss_scene_check_settable(const scene_object *s);

/* ---- holes_api.c */

/* Checks the weights that a host gives for the corners of a triangle: 0 to 1 each, with a sum of 1. */
vbss_result vbss_scene_check_weights(vbss_context *context, const double *weights);

/* Radius of a thread or needle, m. */
double vbss_scene_suture_radius(const scene_body *suture);

/* ---- host_surface_api.c */

/* Finds a host surface by its number. VBSS_ERROR_NOT_FOUND, or VBSS_ERROR_INCOMPATIBLE for another body. */
vbss_result vbss_scene_require_surface(const scene_object *s, uint32_t number, scene_body **b);

/* ---- edit.c */

/* An edit under way, with the state before it. */
typedef struct scene_edit {
    vbss_scene *scene;
    vbss_edit *input; /* as records of the scene see the edit */
    uint8_t
        *backup;  /* NULL: no step is suspended, and the edit itself changes nothing on failure */
    size_t count; /* bytes */
} scene_edit;

/* Begins an edit, for which a suspended step ends. The caller has checked its arguments, and must
 * call vbss_scene_end_edit unless this call fails. Returns VBSS_ERROR_OUT_OF_MEMORY, without any
 * change, if there is no room for the way back, or the refusal of a record. */
vbss_result vbss_scene_begin_edit(vbss_scene *scene, vbss_edit *input, scene_edit *edit);

/* Ends an edit with its result, which it returns. On failure the scene returns to the suspended
 * step. */
vbss_result vbss_scene_end_edit(scene_edit *edit, vbss_result result);

#endif
