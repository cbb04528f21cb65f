/* Tuned numbers of lib/scene.
 *
 * Each entry gives its unit, and whether it is relative or absolute; its origin: derived, fitted, chosen or
 * published; and its test: the scenes of determinism.golden that fail when it is halved or doubled, among the
 * five of the bench tuning (docs/notebook/tuning.md).
 * That page says why a number stays absolute. */
#ifndef VBSS_SCENE_TUNING_H
#define VBSS_SCENE_TUNING_H

#include "base/tune.h"

/* ---- Distances that several folders use */

/* A strand that leaves a body or jaws does not touch them within this arc length.
 * Unit: 1, relative to the contact distance. Origin: chosen. Test: halved scene-tools, graspers; doubled
 * scene-mesh, needle-hands. */
#define SCENE_EXCLUSION_ARC_RATIO VBSS_TUNE(SCENE_EXCLUSION_ARC_RATIO, 1.6)
/* Radius of a free edge against another. At zero CCD could not tell their sides.
 * Unit: 1, relative to the thickness of the wall. Origin: chosen. Test: session. */
#define SCENE_LIP_RADIUS_RATIO VBSS_TUNE(SCENE_LIP_RADIUS_RATIO, 0.1)
/* Arc length from the end within which a contact is one of the tip.
 * Unit: 1, relative to the radius of the wire. Origin: chosen. Test: none known. */
#define SCENE_TIP_LENGTH_RATIO VBSS_TUNE(SCENE_TIP_LENGTH_RATIO, 1.0)
/* Axes that are nearer define no direction.
 * Unit: 1, relative to the contact distance. Origin: chosen: 1e-12 m between threads of the default diameter.
 * Test: none known. */
#define SCENE_MIN_DISTANCE_RATIO VBSS_TUNE(SCENE_MIN_DISTANCE_RATIO, 4e-9)

/* ---- Rolls of threads with friction torque (solve/rolls.c) */

/* Mass that resists roll within a substep, so that a thread that nothing holds has a roll.
 * Unit: 1, relative to the mass of a segment. Origin: chosen: far below the spin inertia, which is a half, and far
 * above rounding. Test: none known. */
#define SCENE_ROLL_MASS_RATIO VBSS_TUNE(SCENE_ROLL_MASS_RATIO, 1e-6)

/* ---- Contacts of threads that slide (contacts/sliding_contacts.c) */

/* Damping of the least squares that find where two threads cross at the end of a substep.
 * Unit: 1. Origin: chosen: threads at less than about 8 degrees count as parallel. Test: none known. */
#define SCENE_SLIDE_DAMPING VBSS_TUNE(SCENE_SLIDE_DAMPING, 0.02)
/* Beyond this slide in a substep a contact of two threads stays where it is at the start: 250 mm/s of the default thread
 * at 1 ms.
 * Unit: 1, relative to the contact distance. Origin: chosen from 0.12 to 1 by how many half hitches seat too tightly at
 * 1 ms (docs/notebook/bends.md). Test: none known. */
#define SCENE_MAX_SLIDE_RATIO VBSS_TUNE(SCENE_MAX_SLIDE_RATIO, 1.0)

/* ---- Work in operations of the step budget (world/work_budget.c, solve/newton.c, step/time_slice.c) */

/* Speed of a core without calibration, and of the cores of older logs.
 * Unit: operations per us, absolute. Origin: chosen: a core of 2.6 GHz, for which the default budgets are 250000
 * and 210000 operations (docs/explanation/real-time.md). Test: session. */
#define SCENE_DEFAULT_OPERATIONS_PER_US 500.0

/* Cost of a candidate pair in an attempt.
 * Unit: operations. Origin: fitted: thread CPU time of the 36000 steps of a surgeon's first throw. Test:
 * scene-tools, scene-mesh, graspers, needle-hands, session. */
#define SCENE_CANDIDATE_COST VBSS_TUNE(SCENE_CANDIDATE_COST, 60)
/* Cost of a node in an attempt.
 * Unit: operations. Origin: fitted: thread CPU time of the 36000 steps of a surgeon's first throw. Test:
 * scene-tools, scene-mesh, graspers, needle-hands, session. */
#define SCENE_ATTEMPT_NODE_COST VBSS_TUNE(SCENE_ATTEMPT_NODE_COST, 20)
/* Cost of a node in a linearisation.
 * Unit: operations. Origin: fitted: thread CPU time of the 36000 steps of a surgeon's first throw. Test:
 * scene-tools, scene-mesh, graspers, needle-hands, session. */
#define SCENE_NODE_COST VBSS_TUNE(SCENE_NODE_COST, 60)
/* Cost of a contact constraint in a linearisation.
 * Unit: operations. Origin: fitted: thread CPU time of the 36000 steps of a surgeon's first throw. Test:
 * scene-tools, scene-mesh, graspers, needle-hands, session. */
#define SCENE_CONSTRAINT_COST VBSS_TUNE(SCENE_CONSTRAINT_COST, 60)
/* Cost of a triangle in a linearisation.
 * Unit: operations. Origin: fitted: thread CPU time of the 36000 steps of a surgeon's first throw. Test:
 * session. */
#define SCENE_TRIANGLE_COST VBSS_TUNE(SCENE_TRIANGLE_COST, 40)
/* Cost of a triangle where the linearisation keeps its matrix.
 * Unit: operations. Origin: fitted: thread CPU time of the 36000 steps of a surgeon's first throw. Test:
 * session. */
#define SCENE_CORRECTION_COST VBSS_TUNE(SCENE_CORRECTION_COST, 12)
/* A correction of drains begins while a step has used no more than this of its operations.
 * Unit: 1, relative to the step budget. Origin: chosen: docs/notebook/drain-corrections.md. Test: session. */
#define SCENE_CORRECTION_BUDGET_RATIO VBSS_TUNE(SCENE_CORRECTION_BUDGET_RATIO, 0.4)
/* A search leaves this much work for another linearisation and its solve.
 * Unit: halves of a linearisation. Origin: chosen. Test: halved session; doubled scene-tools, session. */
#define SCENE_RESERVE_HALVES VBSS_TUNE(SCENE_RESERVE_HALVES, 3)
/* Limits of work and of attempts that the first step of a scene has. Bodies may overlap as the host has placed
 * them, and nothing is known of their contacts.
 * Unit: limits of a step. Origin: chosen: half as much again as the first step of a session takes. Test: session. */
#define SCENE_FIRST_STEP_LIMITS VBSS_TUNE(SCENE_FIRST_STEP_LIMITS, 32)
/* The end of a step costs the cost of an attempt divided by this.
 * Unit: 1. Origin: chosen. Test: session. */
#define SCENE_STEP_END_DIVISOR VBSS_TUNE(SCENE_STEP_END_DIVISOR, 2)

/* ---- Time slicing (step/time_slice.c) */

/* More deferred steps than these are dropped, since hands feel the delay.
 * Unit: steps. Origin: chosen. Test: session. */
#define SCENE_MAX_STEPS_BEHIND VBSS_TUNE(SCENE_MAX_STEPS_BEHIND, 2)
/* A step that this many calls have suspended runs to its end in the next call. Bodies beside an expensive
 * island would stand still otherwise.
 * Unit: calls. Origin: chosen, since free bodies may miss three calls: two of them, and one that begins the next step. Test: fuzz.scenes, scene.time_slicing. */
#define SCENE_MAX_SUSPENSIONS VBSS_TUNE(SCENE_MAX_SUSPENSIONS, 2)
/* Steps that run in one slice after a host edit abandons a step. A host that edits before each step would get
 * nowhere.
 * Unit: steps. Origin: chosen. Test: none known. */
#define SCENE_UNSLICED_STEPS VBSS_TUNE(SCENE_UNSLICED_STEPS, 1000)

/* ---- Tools (tools/, api/add_grasper.c) */

/* Radius of gyration of a tool about its tip.
 * Unit: m, absolute. Origin: chosen. Test: graspers, needle-hands. */
#define SCENE_GYRATION_RADIUS VBSS_TUNE(SCENE_GYRATION_RADIUS, 0.03)
/* Jaws also grasp a strand that they would touch within this angle of the one that stops them.
 * Unit: rad. Origin: chosen. Test: none known. */
#define SCENE_JAW_COMPLIANCE_ANGLE VBSS_TUNE(SCENE_JAW_COMPLIANCE_ANGLE, 0.02)
/* Part of the contact distance that jaws keep to the wall that they grasp or have released.
 * Unit: 1, relative to the contact distance. Origin: chosen, below the distance at the pivot. Test:
 * scene.hand_speeds. */
#define SCENE_HELD_WALL_CONTACT_SCALE VBSS_TUNE(SCENE_HELD_WALL_CONTACT_SCALE, 0.25)
/* Released jaws keep the reduced contact distance until all of the wall is this far away.
 * Unit: 1, relative to the contact distance. Origin: chosen, 1 less the overlap of a loaded contact.
 * Test: scene.hand_speeds. */
#define SCENE_WALL_CLEARANCE_RATIO VBSS_TUNE(SCENE_WALL_CLEARANCE_RATIO, 0.95)
/* Released jaws exclude contacts with a strand or needle until it is this far away.
 * Unit: 1, relative to the contact distance. Origin: chosen. Test: halved none known; doubled needle-hands. */
#define SCENE_RELEASE_CLEARANCE_RATIO VBSS_TUNE(SCENE_RELEASE_CLEARANCE_RATIO, 0.5)
/* Straight pieces in which jaws search the arc of a needle.
 * Unit: pieces of a capsule. Origin: chosen. Test: needle-hands. */
#define SCENE_NEEDLE_ARC_SAMPLES VBSS_TUNE(SCENE_NEEDLE_ARC_SAMPLES, 4)
/* Jaws push aside a needle that is steeper across the mouth than this.
 * Unit: 1, cosine. Origin: chosen. Test: halved none known; doubled needle-hands. */
#define SCENE_NEEDLE_MIN_ACROSS VBSS_TUNE(SCENE_NEEDLE_MIN_ACROSS, 0.8)
/* A needle that lies farther beside the middle is regrasped.
 * Unit: 1, relative to the radius of the jaws. Origin: chosen. Test: none known. */
#define SCENE_NEEDLE_REGRASP_OFFSET VBSS_TUNE(SCENE_NEEDLE_REGRASP_OFFSET, 0.25)
/* A needle is regrasped only if it is at least this much along the jaws.
 * Unit: 1, cosine. Origin: chosen. Test: none known. */
#define SCENE_NEEDLE_MIN_ALONG VBSS_TUNE(SCENE_NEEDLE_MIN_ALONG, 0.5)
/* Jaws search for strands within this distance and a segment.
 * Unit: 1, relative to the length of the jaws. Origin: chosen. Test: halved graspers; doubled none known. */
#define SCENE_STRAND_SEARCH_RATIO VBSS_TUNE(SCENE_STRAND_SEARCH_RATIO, 1.1)
/* Jaws search for a wall if a node of it is within this distance.
 * Unit: 1, relative to the length of the jaws. Origin: chosen. Test: none known. */
#define SCENE_WALL_SEARCH_RATIO VBSS_TUNE(SCENE_WALL_SEARCH_RATIO, 1.5)

/* ---- Holes (tissue/, contacts/hole_constraints.c, contacts/hole_exclusion.c) */

/* A tip, an end or a swage leaves a hole this far beyond where it entered: hysteresis against tremor.
 * Unit: m, absolute. Origin: chosen. Test: none known. */
#define SCENE_HOLE_EXIT_DISTANCE VBSS_TUNE(SCENE_HOLE_EXIT_DISTANCE, 0.2e-3)
/* A hole has constraints of thread and needle if it can reach the swage at this speed within the step.
 * Unit: m/s, relative to the length of the step. Origin: chosen: 2 mm in 1 ms. Test: none known. */
#define SCENE_MAX_SLIDING_SPEED VBSS_TUNE(SCENE_MAX_SLIDING_SPEED, 2.0)
/* A thread does not touch the wall within this arc length of its hole.
 * Unit: 1, relative to the contact distance. Origin: chosen. Test: session. */
#define SCENE_THREAD_EXCLUSION_ARC VBSS_TUNE(SCENE_THREAD_EXCLUSION_ARC, 1.5)
/* The contact distance grows from zero over this arc length beyond the excluded one.
 * Unit: 1, relative to the excluded arc length. Origin: chosen. Test: none known. */
#define SCENE_EXIT_RAMP_RATIO VBSS_TUNE(SCENE_EXIT_RAMP_RATIO, 1.0)
/* A thread on the wrong side of the wall may return through it this far beyond the ramp.
 * Unit: segments. Origin: chosen. Test: scene.hole_passage. */
#define SCENE_RETURN_SEGMENTS VBSS_TUNE(SCENE_RETURN_SEGMENTS, 1.0)

/* ---- Cuts and remeshing (topology/) */

/* Steps by backward Euler after a cut.
 * Unit: steps. Origin: chosen. Test: halved none known; doubled scene-mesh, graspers. */
#define SCENE_CUT_DAMPED_STEPS VBSS_TUNE(SCENE_CUT_DAMPED_STEPS, 3)
/* Shortens the arc, so that an exact multiple of the distance counts as outside.
 * Unit: 1, relative to the excluded arc length. Origin: chosen. Test: none known. */
#define SCENE_CUT_EXCLUSION_ROUNDING VBSS_TUNE(SCENE_CUT_EXCLUSION_ROUNDING, 1e-12)
/* Preferred length of segments on a tool.
 * Unit: 1, relative to the radius of the tool. Origin: chosen. Test: none known. */
#define SCENE_REMESH_TOOL_RATIO VBSS_TUNE(SCENE_REMESH_TOOL_RATIO, 0.25)
/* Two changes of one thread in a step are at least this far apart.
 * Unit: nodes. Origin: chosen. Test: scene-mesh. */
#define SCENE_REMESH_MIN_NODES_BETWEEN VBSS_TUNE(SCENE_REMESH_MIN_NODES_BETWEEN, 10)
/* A change moves a node by at most this.
 * Unit: 1, relative to the segment. Origin: chosen. Test: none known. */
#define SCENE_REMESH_SHIFT_RATIO VBSS_TUNE(SCENE_REMESH_SHIFT_RATIO, 0.05)
/* A change moves a node by at most this fraction of the gap to its neighbour.
 * Unit: 1, relative to the gap. Origin: derived: two sides move, and half of the gap stays. Test: scene-mesh. */
#define SCENE_REMESH_GAP_RATIO VBSS_TUNE(SCENE_REMESH_GAP_RATIO, 0.25)
/* A strand of the same thread is a neighbour beyond this arc length.
 * Unit: 1, relative to the contact distance. Origin: chosen. Test: none known. */
#define SCENE_REMESH_SELF_ARC_RATIO VBSS_TUNE(SCENE_REMESH_SELF_ARC_RATIO, 2.0)
/* Segments this close to a cut end keep their length.
 * Unit: nodes. Origin: chosen. Test: scene-mesh. */
#define SCENE_CUT_END_NODES VBSS_TUNE(SCENE_CUT_END_NODES, 4)
/* A contact this close to an end of a split segment moves to the node there.
 * Unit: 1, relative to the segment. Origin: chosen. Test: none known. */
#define SCENE_RENUMBER_END_FRACTION VBSS_TUNE(SCENE_RENUMBER_END_FRACTION, 0.25)
/* A drain touches itself beyond this arc length, and is only bent within it.
 * Unit: 1, relative to the thickness of the wall. Origin: chosen. Test: session. */
#define SCENE_DRAIN_SELF_ARC_RATIO VBSS_TUNE(SCENE_DRAIN_SELF_ARC_RATIO, 3.0)

/* ---- Contacts (contacts/) */

/* Motion bounds extend displacements by this, as velocities change within a substep.
 * Unit: 1, relative to the substep. Origin: chosen. Test: scene-tools, scene-mesh, graspers, needle-hands,
 * session. */
#define SCENE_EXTRAPOLATION_RATIO VBSS_TUNE(SCENE_EXTRAPOLATION_RATIO, 1.2)
/* Part of the lateral motion that counts as approach, since normals turn.
 * Unit: 1, relative to the displacement across the normal. Origin: chosen. Test: scene-mesh, session. */
#define SCENE_LATERAL_RATIO VBSS_TUNE(SCENE_LATERAL_RATIO, 0.1)
/* A contact with the floor is created within this distance.
 * Unit: 1, relative to the extended displacement. Origin: chosen. Test: halved scene-tools, needle-hands;
 * doubled none known. */
#define SCENE_FLOOR_REACH_RATIO VBSS_TUNE(SCENE_FLOOR_REACH_RATIO, 1.01)
/* Friction augmentation of a contact of threads. It should grow with node mass / h^2; a thousand times as much
 * makes the active set cycle.
 * Unit: N/m, absolute. Origin: chosen. Test: scene-tools, scene-mesh, graspers, needle-hands, session. */
#define SCENE_NODE_AUGMENTATION VBSS_TUNE(SCENE_NODE_AUGMENTATION, 3.0)
/* Friction augmentation of a contact of rigid bodies alone, well below the inertia of a point of them.
 * Unit: 1, relative to mass / h^2. Origin: chosen. Test: scene-tools, needle-hands. */
#define SCENE_RIGID_AUGMENTATION VBSS_TUNE(SCENE_RIGID_AUGMENTATION, 0.01)
/* Elastic slip of a node on the floor. Without it, nodes under their own weight stop sticking one per solve.
 * Unit: 1, relative to the diameter of the thread. Origin: chosen: 1e-7 m at the default diameter. Test: scene-
 * tools, needle-hands. */
#define SCENE_FLOOR_ELASTIC_SLIP_RATIO VBSS_TUNE(SCENE_FLOOR_ELASTIC_SLIP_RATIO, 1e-7 / 0.25e-3)
/* A predicted normal replaces the current one if it is at least this close to it.
 * Unit: 1, cosine. Origin: chosen. Test: halved none known; doubled scene-tools, graspers, needle-hands. */
#define SCENE_MIN_NORMAL_COSINE VBSS_TUNE(SCENE_MIN_NORMAL_COSINE, 0.5)
/* The edge of a static mesh pushes along the normal of a triangle unless the other body is below its plane by more than this.
 * Unit: 1, relative to the contact distance. Origin: chosen: 1e-2 brakes a thread over a cylinder of 18 cells by a
 * tenth of its tension. Test: scene.static_mesh. */
#define SCENE_PLANE_TOLERANCE VBSS_TUNE(SCENE_PLANE_TOLERANCE, 1e-4)
/* A predicted normal is used if the predicted axes are farther apart than this.
 * Unit: 1, relative to the contact distance. Origin: chosen. Test: halved none known; doubled scene-tools,
 * graspers, needle-hands. */
#define SCENE_MIN_PREDICTED_RATIO VBSS_TUNE(SCENE_MIN_PREDICTED_RATIO, 0.5)
/* In real time, an overlap of a fold that no force explains is deep from here on.
 * Unit: 1, relative to the thickness of the wall. Origin: chosen, ten times the overlap that a real-time
 * substep leaves. Test: scene.hand_speeds. */
#define SCENE_DEEP_FOLD_RATIO VBSS_TUNE(SCENE_DEEP_FOLD_RATIO, 0.2)
/* A fold that starts too deep opens at this rate.
 * Unit: 1/s, relative to the thickness of the wall. Origin: chosen. Test: none known. */
#define SCENE_FOLD_OPENING_RATE VBSS_TUNE(SCENE_FOLD_OPENING_RATE, 20.0)
/* Speed at which rigid bodies that overlap without a force are pushed apart.
 * Unit: 1/s, relative to the contact distance. Origin: chosen: the deepest overlap is gone after 50 ms.
 * Test: scene.overlapping_start. */
#define SCENE_RECOVERY_RATE VBSS_TUNE(SCENE_RECOVERY_RATE, 20.0)

/* ---- Prediction and Newton (solve/predict.c, solve/newton.c) */

/* Steps by backward Euler after the last contact of a thread.
 * Unit: steps. Origin: chosen. Test: scene-tools, scene-mesh, graspers. */
#define SCENE_DAMPED_STEPS_AFTER_CONTACT VBSS_TUNE(SCENE_DAMPED_STEPS_AFTER_CONTACT, 3)
/* A force residual below this counts as converged.
 * Unit: 1, relative to the normal force. Origin: chosen. Test: scene-tools, scene-mesh, graspers, needle-
 * hands, session. */
#define SCENE_FORCE_TOLERANCE_RATIO VBSS_TUNE(SCENE_FORCE_TOLERANCE_RATIO, 1e-3)
/* Added to the relative tolerance of the force.
 * Unit: N, absolute. Origin: chosen. Test: scene-mesh, needle-hands, session. */
#define SCENE_FORCE_TOLERANCE VBSS_TUNE(SCENE_FORCE_TOLERANCE, 1e-7)
/* An overlap below this counts as converged.
 * Unit: 1, relative to the contact distance. Origin: chosen. Test: scene-tools, scene-mesh, needle-hands,
 * session. */
#define SCENE_OVERLAP_TOLERANCE VBSS_TUNE(SCENE_OVERLAP_TOLERANCE, 1e-4)
/* Solves without progress after which the loose tolerances apply.
 * Unit: solves. Origin: chosen. Test: halved scene-tools, scene-mesh, needle-hands, session; doubled scene-
 * mesh, needle-hands, session. */
#define SCENE_MAX_STALLED_SOLVES VBSS_TUNE(SCENE_MAX_STALLED_SOLVES, 6u)
/* Tolerance of the force where the active set cycles.
 * Unit: 1, relative to the normal force. Origin: chosen. Test: scene-tools, scene-mesh, needle-hands, session. */
#define SCENE_LOOSE_FORCE_TOLERANCE VBSS_TUNE(SCENE_LOOSE_FORCE_TOLERANCE, 0.05)
/* Tolerance of the overlap where the active set cycles.
 * Unit: 1, relative to the contact distance. Origin: chosen. Test: none known. */
#define SCENE_LOOSE_OVERLAP_TOLERANCE VBSS_TUNE(SCENE_LOOSE_OVERLAP_TOLERANCE, 0.02)
/* Linearisations beyond the work limit: two give 10 % more paused steps.
 * Unit: linearisations. Origin: chosen. Test: halved session; doubled none known. */
#define SCENE_OVER_BUDGET_LINEARISATIONS VBSS_TUNE(SCENE_OVER_BUDGET_LINEARISATIONS, 4)
/* A larger strain in the last search rejects the substep, unless it falls fast.
 * Unit: 1, strain. Origin: chosen. Test: none known. */
#define SCENE_DIVERGING_STRETCH VBSS_TUNE(SCENE_DIVERGING_STRETCH, 0.1)
/* A strain that falls to this fraction still converges.
 * Unit: 1, relative to the strain before. Origin: chosen. Test: none known. */
#define SCENE_CONVERGING_RATIO VBSS_TUNE(SCENE_CONVERGING_RATIO, 0.5)
/* Updates of the contact normals in a substep that slides far.
 * Unit: updates. Origin: chosen. Test: none known. */
#define SCENE_MAX_NORMAL_UPDATES VBSS_TUNE(SCENE_MAX_NORMAL_UPDATES, 3)
/* A needle in a hole that turns farther needs another linearisation. Its stiff constraints would store the
 * difference between chord and arc as energy.
 * Unit: rad. Origin: chosen. Test: none known. */
#define SCENE_MAX_NEEDLE_ROTATION VBSS_TUNE(SCENE_MAX_NEEDLE_ROTATION, 0.05)
/* Further linearisations for a turning needle, after which the substep is halved.
 * Unit: linearisations. Origin: chosen. Test: none known. */
#define SCENE_NEEDLE_LINEARISATIONS VBSS_TUNE(SCENE_NEEDLE_LINEARISATIONS, 4)

/* ---- Energy check of a stopped search (solve/energy_check.c) */

/* Largest energy gain in a scene without drains, where friction dissipates it.
 * Unit: W, relative to the length of the step. Origin: derived: the power of a quick hand, 2 N at 0.5 m/s.
 * Test: none known. */
#define SCENE_POWER_WITHOUT_WALLS VBSS_TUNE(SCENE_POWER_WITHOUT_WALLS, 1.0)
/* Largest energy gain in a scene with drains, which store it.
 * Unit: W, relative to the length of the step. Origin: fitted: `tests/run.sh soak tugs`. Test: session. */
#define SCENE_POWER_WITH_WALLS VBSS_TUNE(SCENE_POWER_WITH_WALLS, 0.02)
/* A gain beyond this after the first linearisation rejects the substep at once.
 * Unit: 1, relative to SCENE_POWER_WITH_WALLS. Origin: fitted: 7806 stopped substeps of two seeds of a
 * surgeon. Test: session. */
#define SCENE_HOPELESS_ENERGY_RATIO VBSS_TUNE(SCENE_HOPELESS_ENERGY_RATIO, 3.0)

/* ---- Capacity of the system (solve/system_capacity.c); a scene that needs more reports CAPACITY */

/* Default of matrix_capacity for each block of a thread or rigid body. A node without contact takes up to 12, and a
 * node of a tight knot 42.
 * Unit: blocks. Origin: fitted: docs/reference/memory.md. Test: scene.matrix_capacity. */
#define SCENE_MATRIX_PER_BLOCK VBSS_TUNE(SCENE_MATRIX_PER_BLOCK, 20u)
/* Default of matrix_capacity beside that, for knots on short threads.
 * Unit: blocks. Origin: fitted: docs/reference/memory.md. Test: scene.matrix_capacity. */
#define SCENE_MATRIX_BASE VBSS_TUNE(SCENE_MATRIX_BASE, 4096u)
/* There is room for the indices of one pair of separators for each of this number of blocks of matrix_capacity.
 * Unit: blocks. Origin: fitted: 7 on the floor, 10 in a knot. Test: scene.matrix_capacity. */
#define SCENE_MATRIX_PER_PAIR VBSS_TUNE(SCENE_MATRIX_PER_PAIR, 6u)
/* The same for one pair of the separators' factor.
 * Unit: blocks. Origin: fitted: 4 in a knot. Test: scene.matrix_capacity. */
#define SCENE_MATRIX_PER_FACTOR_PAIR VBSS_TUNE(SCENE_MATRIX_PER_FACTOR_PAIR, 3u)
/* Limits of the compliance of a vertex: its smallest and largest number unless all are zero, m/N, and the smallest pivot
 * relative to the largest number.
 * Unit: m/N; 1. Origin: chosen: from a thousandth of the contact's own compliance of 5e-6 to a gram at 1 kHz and far
 * beyond; the pivot keeps the inverse accurate. Test: scene.host_surface_state. */
#define SCENE_MIN_COMPLIANCE VBSS_TUNE(SCENE_MIN_COMPLIANCE, 1e-9)
#define SCENE_MAX_COMPLIANCE VBSS_TUNE(SCENE_MAX_COMPLIANCE, 1e6)
#define SCENE_MIN_COMPLIANCE_RATIO VBSS_TUNE(SCENE_MIN_COMPLIANCE_RATIO, 1e-6)
/* Vertices of a compliant surface that contacts may touch at a time.
 * Unit: vertices. Origin: chosen: a thread of 300 segments on a fine mesh. Test: none known. */
#define SCENE_MAX_TOUCHED_VERTICES VBSS_TUNE(SCENE_MAX_TOUCHED_VERTICES, 1024u)
/* Coupled pairs of blocks per node of a drain, with fill-in.
 * Unit: pairs. Origin: chosen. Test: none known. */
#define SCENE_PAIRS_PER_DRAIN_NODE VBSS_TUNE(SCENE_PAIRS_PER_DRAIN_NODE, 128u)
/* Blocks of the matrix for each block of the factor of a drain alone, which takes two.
 * Unit: blocks. Origin: chosen. Test: none known. */
#define SCENE_MATRIX_PER_DRAIN_ENTRY VBSS_TUNE(SCENE_MATRIX_PER_DRAIN_ENTRY, 8u)
/* Entries of the factor when separators are eliminated late.
 * Unit: 1, relative to the factor of the drain alone. Origin: chosen. Test: none known. */
#define SCENE_FILL_IN_ENTRY_RATIO VBSS_TUNE(SCENE_FILL_IN_ENTRY_RATIO, 4u)
/* Products of the elimination when separators are eliminated late.
 * Unit: 1, relative to the factor of the drain alone. Origin: chosen. Test: none known. */
#define SCENE_FILL_IN_PRODUCT_RATIO VBSS_TUNE(SCENE_FILL_IN_PRODUCT_RATIO, 8u)

/* ---- Continuous collision detection (ccd) */

/* Bodies count as held back until they have moved freely for this time.
 * Unit: s. Origin: chosen: hosts show it to people. Test: scene.islands. */
#define SCENE_BLOCKER_MEMORY VBSS_TUNE(SCENE_BLOCKER_MEMORY, 0.1)
/* Axes stay at least this far apart.
 * Unit: 1, relative to the contact distance. Origin: chosen. Test: none known. */
#define SCENE_CCD_DISTANCE_RATIO VBSS_TUNE(SCENE_CCD_DISTANCE_RATIO, 0.5)
/* A pair that starts nearer may approach to this fraction.
 * Unit: 1, relative to the distance at the start. Origin: chosen. Test: none known. */
#define SCENE_CCD_RATIO_WHEN_NEARER VBSS_TUNE(SCENE_CCD_RATIO_WHEN_NEARER, 0.9)
/* A pair below this does not approach at all, so that a test can still prove that it separates.
 * Unit: 1, relative to the CCD distance. Origin: chosen. Test: none known. */
#define SCENE_CCD_MIN_DISTANCE_RATIO VBSS_TUNE(SCENE_CCD_MIN_DISTANCE_RATIO, 0.1)
/* The distance of a pair at a hole is sampled at least this often.
 * Unit: evaluations a substep. Origin: chosen. Test: none known. */
#define SCENE_CCD_HOLE_EVALUATIONS VBSS_TUNE(SCENE_CCD_HOLE_EVALUATIONS, 8)
/* Largest number of queries of a pair at a hole.
 * Unit: queries a substep. Origin: chosen. Test: none known. */
#define SCENE_CCD_HOLE_QUERIES VBSS_TUNE(SCENE_CCD_HOLE_QUERIES, 80)
/* A node or the end of a capsule stays at least this far above the floor.
 * Unit: 1, relative to the radius. Origin: chosen. Test: halved none known; doubled scene-tools, needle-hands. */
#define SCENE_CCD_FLOOR_RATIO VBSS_TUNE(SCENE_CCD_FLOOR_RATIO, 0.5)
/* Margin by which the search of CCD extends each of two bodies.
 * Unit: 1, relative to the contact margin. Origin: derived: a half, less rounding. Test: scene-tools, scene-
 * mesh, graspers, needle-hands. */
#define SCENE_CCD_MARGIN_RATIO VBSS_TUNE(SCENE_CCD_MARGIN_RATIO, 0.49)
/* A contact that starts with a larger overlap is deep, and CCD tests its bodies.
 * Unit: 1, relative to the contact distance. Origin: derived: smoothed nodes then start at 0.71, segments at
 * 0.6, and stay beyond 0.4. Test: none known. */
#define SCENE_CCD_DEEP_RATIO VBSS_TUNE(SCENE_CCD_DEEP_RATIO, 0.2)
/* Two bodies that move by less in a substep need no test.
 * Unit: 1, relative to the contact distance. Origin: derived: with SCENE_CCD_DEEP_RATIO. Test: scene-tools,
 * scene-mesh, graspers, needle-hands. */
#define SCENE_CCD_SLOW_MOTION_RATIO VBSS_TUNE(SCENE_CCD_SLOW_MOTION_RATIO, 0.2)

/* ---- Truncation (ccd/truncate_substep.c) */

/* A truncated substep ends at this fraction.
 * Unit: 1, relative to the time of impact. Origin: chosen. Test: none known. */
#define SCENE_SAFE_FRACTION VBSS_TUNE(SCENE_SAFE_FRACTION, 0.9)
/* Velocity that a truncated substep keeps.
 * Unit: 1, relative to the mean velocity. Origin: chosen. Test: none known. */
#define SCENE_VELOCITY_FRACTION VBSS_TUNE(SCENE_VELOCITY_FRACTION, 0.1)
/* Halvings of the fraction in a truncation, after which nothing moves.
 * Unit: truncations. Origin: derived: a segment that turns by 90 degrees is shorter by 29 %, and after nine halvings by
 * the stretch tolerance of 0.1 %. Test: none known. */
#define SCENE_MAX_TRUNCATIONS VBSS_TUNE(SCENE_MAX_TRUNCATIONS, 9)
/* A trial state of larger strain is not truncated but dropped.
 * Unit: 1, strain. Origin: chosen. Test: none known. */
#define SCENE_MAX_TRIAL_STRETCH VBSS_TUNE(SCENE_MAX_TRIAL_STRETCH, 0.05)

/* ---- Substeps (step/) */

/* A contact that starts too deep may deepen by this in a substep.
 * Unit: 1, relative to the penetration tolerance. Origin: chosen. Test: none known. */
#define SCENE_ALLOWED_DEEPENING VBSS_TUNE(SCENE_ALLOWED_DEEPENING, 0.1)
/* Smallest substep in a scene with drains, where a snap-through takes too much work. Without drains each
 * substep may gain 1 mJ in a step of 1 ms, and more of them would gain more.
 * Unit: 1, relative to the smallest substep. Origin: fitted: four seeds of a surgeon, in which the step of
 * most work fell from 1.9e6 to 0.55e6 operations. Test: none known. */
#define SCENE_HARD_MIN_SIZE_RATIO VBSS_TUNE(SCENE_HARD_MIN_SIZE_RATIO, 0.125)

/* Truncated substeps after which a step without a budget leaves out its rest.
 * Unit: substeps. Origin: chosen: a quarter of a step at the default halving_limit. Test:
 * scene.islands. */
#define SCENE_MAX_TRUNCATED_SUBSTEPS VBSS_TUNE(SCENE_MAX_TRUNCATED_SUBSTEPS, 8u)

/* ---- Host edits (api/holes_api.c) */

/* The weights of a point may miss a sum of 1 by this.
 * Unit: 1. Origin: chosen. Test: none known. */
#define SCENE_WEIGHT_ROUNDING VBSS_TUNE(SCENE_WEIGHT_ROUNDING, 1e-9)

/* ---- Baseline (baseline/contacts.c, holes.c, needles.c) */

/* A smaller response is rounding.
 * Unit: 1, relative to the thickness. Origin: chosen. Test: none known. */
#define BASELINE_MIN_DEPTH_RATIO VBSS_TUNE(BASELINE_MIN_DEPTH_RATIO, 1e-9)
/* Largest move of a node. Near a pinned node the other has a long lever.
 * Unit: 1, relative to the shift of the contact point. Origin: derived: two free nodes of equal mass never
 * exceed 1.21. Test: none known. */
#define BASELINE_MAX_LEVER VBSS_TUNE(BASELINE_MAX_LEVER, 1.25)
/* Straight pieces in which jaws search the arc of a needle.
 * Unit: pieces of a capsule. Origin: chosen. Test: none known. */
#define BASELINE_NEEDLE_ARC_SAMPLES VBSS_TUNE(BASELINE_NEEDLE_ARC_SAMPLES, 4)
/* Rounds of impulses over the ends of capsules on the floor.
 * Unit: rounds. Origin: chosen. Test: none known. */
#define BASELINE_LANDING_ROUNDS VBSS_TUNE(BASELINE_LANDING_ROUNDS, 200)

#endif
