/* One attempt at a substep:
 *
 *   motion bounds -> broad phase -> contacts -> predict -> warm start -> Newton -> CCD */
#include "scene/ccd/ccd.h"
#include "scene/contacts/contacts.h"
#include "scene/solve/solve.h"
#include "scene/step/groups.h"
#include "scene/step/step.h"
#include "scene/tissue/tissue.h"
#include "scene/tuning.h"
#include "scene/world/world.h"

static void set_allowed_penetrations(scene_object *s)
{
    s->step.is_recovering = false;
    for (uint32_t i = 0; i < s->contacts->count; i++) {
        contact_constraint *constraint = &s->contacts->constraints[i];
        if (constraint->is_bilateral) {
            continue;
        }
        double start_gap = scene_geometry_of(s, constraint)->start_gap;
        double allowed_penetration = s->solver.penetration_tolerance * constraint->thickness;
        constraint->allowed_penetration = vbss_max(
            allowed_penetration, SCENE_ALLOWED_DEEPENING * allowed_penetration - start_gap);
        s->step.is_recovering = s->step.is_recovering ||
                                constraint->recovery_allowance - start_gap > allowed_penetration;
    }
}

static scene_substep_outcome begin_attempt(scene_object *s, const scene_substep *substep)
{
    s->report.statistics.attempts++;
    s->step.has_accepted_contacts = false;
    /* Motion bounds, broad phase, narrow phase. */
    const bool has_all_pairs = vbss_scene_create_contacts(s, substep);
    if ((has_all_pairs && vbss_scene_put_free_bodies_first(s)) ||
        vbss_scene_split_slow_islands(s, has_all_pairs)) {
        s->report.statistics.attempts--;
        return SCENE_SUBSTEP_REGROUPED;
    }
    if (!has_all_pairs) {
        /* Which contacts an incomplete list has depends on the separation cache, which a restored
         * scene does not have. So their forces are not published. If the host abandons the step
         * here, reactions come from the prediction, as after any rejected attempt. */
        vbss_contact_clear(s->contacts);
        vbss_scene_predict(s, substep);
        return SCENE_SUBSTEP_OUT_OF_CAPACITY;
    }
    vbss_scene_charge_budget(s, vbss_scene_attempt_cost(s));
    vbss_scene_predict(s, substep);
    vbss_scene_number_blocks(s);
    vbss_scene_release_untouched_vertices(s);
    vbss_scene_init_contacts(s, substep);
    vbss_scene_warm_start_contacts(s, substep);
    set_allowed_penetrations(s);
    if (vbss_scene_build_sparsity_pattern(s) != VBSS_OK) {
        return SCENE_SUBSTEP_OUT_OF_CAPACITY;
    }
    s->contacts->call_budget.has_progress = true;
    return vbss_scene_solve(s, substep);
}

scene_substep_outcome vbss_scene_run_attempt(scene_object *s)
{
    scene_step_cursor *cursor = &s->cursor;
    scene_substep_outcome outcome = cursor->is_attempt_in_memory
                                        ? vbss_scene_resume_solve(s, &cursor->substep)
                                        : begin_attempt(s, &cursor->substep);
    if (outcome == SCENE_SUBSTEP_ACCEPTED && !cursor->substep.is_min_size &&
        vbss_scene_tears_too_far(s)) {
        outcome = SCENE_SUBSTEP_NOT_CONVERGED;
    }
    cursor->is_attempt_suspended = cursor->is_attempt_in_memory =
        outcome == SCENE_SUBSTEP_SUSPENDED;
    cursor->checks_passed = s->contacts->call_budget.checks_passed;
    return outcome == SCENE_SUBSTEP_ACCEPTED ? vbss_scene_run_ccd(s) : outcome;
}

void vbss_scene_count_rejection(scene_object *s, scene_substep_outcome outcome)
{
    vbss_scene_statistics *c = &s->report.statistics;
    c->rejected_states += outcome == SCENE_SUBSTEP_NO_ACTIVE_SET;
    c->rejected_stretch += outcome == SCENE_SUBSTEP_NOT_CONVERGED;
    c->rejected_depth += outcome == SCENE_SUBSTEP_PENETRATION;
    c->rejected_guard += outcome == SCENE_SUBSTEP_CCD_HIT;
    c->rejected_singular += outcome == SCENE_SUBSTEP_SINGULAR;
    c->rejected_full += outcome == SCENE_SUBSTEP_OUT_OF_CAPACITY;
}
