/* Changes of a running scene: friction, gravity, couplings, limits, budgets and contact filters. */
#include "base/api_call.h"
#include "base/check.h"
#include "base/error.h"
#include "scene/api/api.h"
#include "scene/world/world.h"

#include <vblast_ss/scene_settings.h>

/* A change under way: the values and where they go. */
typedef struct setting {
    vbss_edit input; /* words: setting, body, and two of the filter */
    /* Checks that the scene can take the change. Sets the error. */
    vbss_result (*check)(const scene_object *s, const struct setting *setting);
    void (*apply)(scene_object *s, const struct setting *setting);
} setting;

/* The end of a suspended step may remove what the first check has found. */
static vbss_result check_and_apply(scene_object *s, const setting *wanted)
{
    VBSS_TRY(wanted->check(s, wanted));
    wanted->apply(s, wanted);
    s->report.generation++;
    return VBSS_OK;
}

static vbss_result set(vbss_scene *scene, setting *wanted)
{
    scene_edit edit;
    scene_object *s = ((vbss_slot *)scene)->object;
    wanted->input.kind = VBSS_EDIT_SETTING;
    VBSS_TRY(wanted->check(s, wanted));
    VBSS_TRY(vbss_scene_begin_edit(scene, &wanted->input, &edit));
    return vbss_scene_end_edit(&edit, check_and_apply(s, wanted));
}

static vbss_result check_method(const scene_object *s, const setting *wanted)
{
    (void)wanted;
    return vbss_scene_check_settable(s);
}

/* The body, or the floor. */
static vbss_result check_body(const scene_object *s, const setting *wanted)
{
    VBSS_TRY(vbss_scene_check_settable(s));
    scene_body *b;
    return wanted->input.words[1] == 0 ? VBSS_OK
                                       : vbss_scene_require_any_body(s, wanted->input.words[1], &b);
}

/* ---- gravity */

static void set_gravity_of(scene_body *b, vec3 gravity)
{
    if (b->kind == SCENE_BODY_THREAD) {
        b->thread.thread->gravity = gravity;
        b->thread.thread->generation++;
    } else if (b->kind == SCENE_BODY_DRAIN) {
        b->drain.drain->gravity = gravity;
        b->drain.drain->generation++;
    } else if (b->kind == SCENE_BODY_RIGID) {
        b->rigid.body.gravity = gravity;
    }
}

static bool is_carried(const scene_body *b)
{
    return b->kind == SCENE_BODY_RIGID && b->rigid.kind != VBSS_SCENE_RIGID_FREE;
}

static void apply_gravity(scene_object *s, const setting *wanted)
{
    for (uint32_t i = 0; i < s->body_count; i++) {
        scene_body *b = &s->bodies[i];
        if (wanted->input.words[1] == 0 ? !is_carried(b) : b->number == wanted->input.words[1]) {
            set_gravity_of(b, vec3_load(wanted->input.numbers));
        }
    }
}

vbss_result vbss_scene_set_gravity(vbss_scene *scene, uint32_t body, const double gravity[3])
{
    VBSS_ENTER(scene);
    scene_object *s;
    VBSS_TRY(vbss_scene_open_mutable(scene, &s));
    VBSS_TRY(vbss_check_pointer(s->context, gravity, "gravity"));
    VBSS_TRY(vbss_check_vector(s->context, gravity, 1e6, "gravity"));
    setting wanted = {.input = {.words = {VBSS_EDIT_SETTING_GRAVITY, body},
                                .numbers = {gravity[0], gravity[1], gravity[2]}},
                      .check = check_body,
                      .apply = apply_gravity};
    return set(scene, &wanted);
}

/* ---- friction */

static vbss_result check_friction(const scene_object *s, const setting *wanted)
{
    VBSS_TRY(check_body(s, wanted));
    const scene_body *b = vbss_scene_body(s, wanted->input.words[1]);
    if (b != NULL && b->kind == SCENE_BODY_THREAD) {
        return vbss_fail(s->context, VBSS_ERROR_INCOMPATIBLE,
                         "body %u is a thread: vbss_scene_set_thread_friction sets the friction "
                         "of all threads",
                         wanted->input.words[1]);
    }
    return VBSS_OK;
}

static void apply_friction(scene_object *s, const setting *wanted)
{
    scene_body *b = vbss_scene_body(s, wanted->input.words[1]);
    double *friction = b == NULL                     ? &s->settings.floor_friction
                       : b->kind == SCENE_BODY_DRAIN ? &b->drain.friction
                                                     : &b->rigid.friction;
    *friction = wanted->input.numbers[0];
}

vbss_result vbss_scene_set_friction(vbss_scene *scene, uint32_t body, double friction)
{
    VBSS_ENTER(scene);
    scene_object *s;
    VBSS_TRY(vbss_scene_open_mutable(scene, &s));
    VBSS_TRY(vbss_check_range(s->context, friction, 0.0, 10.0, "friction"));
    setting wanted = {.input = {.words = {VBSS_EDIT_SETTING_FRICTION, body}, .numbers = {friction}},
                      .check = check_friction,
                      .apply = apply_friction};
    return set(scene, &wanted);
}

static void apply_thread_friction(scene_object *s, const setting *wanted)
{
    s->settings.thread_friction = wanted->input.numbers[0];
}

vbss_result vbss_scene_set_thread_friction(vbss_scene *scene, double friction)
{
    VBSS_ENTER(scene);
    scene_object *s;
    VBSS_TRY(vbss_scene_open_mutable(scene, &s));
    VBSS_TRY(vbss_check_range(s->context, friction, 0.0, 10.0, "friction"));
    setting wanted = {
        .input = {.words = {VBSS_EDIT_SETTING_THREAD_FRICTION}, .numbers = {friction}},
        .check = check_method,
        .apply = apply_thread_friction};
    return set(scene, &wanted);
}

/* ---- tools */

static vbss_result check_coupling(const scene_object *s, const setting *wanted)
{
    VBSS_TRY(vbss_scene_check_settable(s));
    scene_body *b;
    VBSS_TRY(vbss_scene_require_body(s, wanted->input.words[1], SCENE_BODY_RIGID, &b));
    return b->rigid.kind == VBSS_SCENE_RIGID_COUPLED
               ? VBSS_OK
               : vbss_fail(s->context, VBSS_ERROR_INCOMPATIBLE, "body %u has no coupling",
                           wanted->input.words[1]);
}

static void apply_coupling(scene_object *s, const setting *wanted)
{
    const double *n = wanted->input.numbers;
    vbss_scene_body(s, wanted->input.words[1])->rigid.body.coupling =
        (vbss_rigid_coupling){n[0], n[1], n[2], n[3]};
}

vbss_result vbss_scene_set_coupling(vbss_scene *scene, uint32_t body, double stiffness,
                                    double damping, double turning_stiffness,
                                    double turning_damping)
{
    VBSS_ENTER(scene);
    scene_object *s;
    VBSS_TRY(vbss_scene_open_mutable(scene, &s));
    VBSS_TRY(vbss_check_range(s->context, stiffness, 0.0, 1e9, "stiffness"));
    VBSS_TRY(vbss_check_range(s->context, damping, 0.0, 1e6, "damping"));
    VBSS_TRY(vbss_check_range(s->context, turning_stiffness, 0.0, 1e9, "turning_stiffness"));
    VBSS_TRY(vbss_check_range(s->context, turning_damping, 0.0, 1e6, "turning_damping"));
    setting wanted = {
        .input = {.words = {VBSS_EDIT_SETTING_COUPLING, body},
                  .numbers = {stiffness, damping, turning_stiffness, turning_damping}},
        .check = check_coupling,
        .apply = apply_coupling};
    return set(scene, &wanted);
}

static void apply_speed_limit(scene_object *s, const setting *wanted)
{
    s->settings.speed_limit = wanted->input.numbers[0];
}

vbss_result vbss_scene_set_speed_limit(vbss_scene *scene, double limit)
{
    VBSS_ENTER(scene);
    scene_object *s;
    VBSS_TRY(vbss_scene_open_mutable(scene, &s));
    VBSS_TRY(vbss_check_range(s->context, limit, 0.0, 1e6, "limit"));
    setting wanted = {.input = {.words = {VBSS_EDIT_SETTING_SPEED_LIMIT}, .numbers = {limit}},
                      .check = check_method,
                      .apply = apply_speed_limit};
    return set(scene, &wanted);
}

/* ---- budgets */

static void apply_budgets(scene_object *s, const setting *wanted)
{
    const double *n = wanted->input.numbers;
    s->settings.step_budget = (uint32_t)vbss_scene_count_operations(n[0], n[2]);
    s->settings.call_budget = (uint32_t)vbss_scene_count_operations(n[1], n[2]);
}

vbss_result vbss_scene_set_budgets(vbss_scene *scene, double step_budget_us, double call_budget_us,
                                   double operations_per_us)
{
    VBSS_ENTER(scene);
    scene_object *s;
    VBSS_TRY(vbss_scene_open_mutable(scene, &s));
    VBSS_TRY(vbss_solver_options_check_budgets(s->context, step_budget_us, call_budget_us,
                                               operations_per_us));
    setting wanted = {.input = {.words = {VBSS_EDIT_SETTING_BUDGETS},
                                .numbers = {step_budget_us, call_budget_us, operations_per_us}},
                      .check = check_method,
                      .apply = apply_budgets};
    return set(scene, &wanted);
}

/* ---- filters */

static void apply_filter(scene_object *s, const setting *wanted)
{
    scene_body *b = vbss_scene_body(s, wanted->input.words[1]);
    *(b == NULL ? &s->settings.floor_filter : &b->filter) =
        (scene_filter){wanted->input.words[2], wanted->input.words[3]};
}

vbss_result vbss_scene_set_filter(vbss_scene *scene, uint32_t body, uint32_t category,
                                  uint32_t mask)
{
    VBSS_ENTER(scene);
    scene_object *s;
    VBSS_TRY(vbss_scene_open_mutable(scene, &s));
    setting wanted = {.input = {.words = {VBSS_EDIT_SETTING_FILTER, body, category, mask}},
                      .check = check_body,
                      .apply = apply_filter};
    return set(scene, &wanted);
}
