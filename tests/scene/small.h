/* Small scenes for the tests of what a scene promises: made in a few lines, looked at in one. */
#ifndef VBSS_TESTS_SCENE_SMALL_H
#define VBSS_TESTS_SCENE_SMALL_H

#include <math.h>
#include <string.h>

#include "fixtures/step_events.h"
#include "harness/harness.h"
#include "scene/api/api.h"
#include "scene/world/world.h"

typedef struct small {
    harness_memory memory;
    vbss_context *context;
    vbss_scene *scene;
    vbss_scene_config config;      /* change these four before what they make */
    vbss_thread_config thread;     /* no weight */
    vbss_scene_rigid_config rigid; /* 20 g */
    vbss_drain_config drain;
} small;

/* A context and configurations: of a scene with room for 200 nodes and 8 bodies of either kind. */
void small_begin(small *s);
/* And the scene of them. */
void small_begin_scene(small *s);
void small_create(small *s);
/* Asserts that all memory came back. */
void small_end(small *s);

/* A straight thread from one point to another, tied to nothing; its handle is left out if NULL. */
uint32_t small_thread(small *s, vec3 begin, vec3 end, uint32_t segments, vbss_thread **thread);
/* A drain; its handle is left out if NULL. */
uint32_t small_drain(small *s, vbss_drain **drain);
/* A body of one capsule, whose frame is the world's at first. */
uint32_t small_capsule(small *s, vbss_scene_rigid_kind kind, vec3 begin, vec3 end, double radius);
/* The same about the middle of its axis, which is where its frame's origin is. */
uint32_t small_stick(small *s, vbss_scene_rigid_kind kind, vec3 middle, vec3 half, double radius);
void small_move(small *s, uint32_t body, vec3 position);
uint32_t small_pin(small *s, uint32_t thread, uint32_t node, uint32_t body);
/* Both ends where they are, on the world. */
void small_pin_ends(small *s, uint32_t thread, uint32_t nodes);
void small_steps(small *s, uint32_t count, double h);

uint64_t small_hash(const small *s);
vbss_scene_statistics small_statistics(const small *s);
vbss_scene_rigid_state small_rigid(const small *s, uint32_t body);
vec3 small_position(const small *s, uint32_t body);
vbss_view small_view(const small *s, vbss_scene_field field);
vec3 small_vector(const small *s, vbss_scene_field field, uint64_t i);
/* The bytes of its state, to be freed. */
typedef struct small_state {
    uint8_t *bytes;
    uint64_t count;
} small_state;
small_state small_save(const small *s);
/* Draws a node with that force from now on, N; a gram hangs on it, or it would fly off once it is slack. */
void small_draw(vbss_thread *thread, uint32_t node, vec3 force);
/* Where a node is; the tension of a segment. */
vec3 small_node(vbss_thread *thread, uint32_t node);
double small_tension(vbss_thread *thread, uint32_t segment);
/* Of all of it. Stretching by the tensions: by the lengths it would be that of the stretch error, which is no force. */
double small_thread_energy(vbss_thread *thread, double axial_stiffness);
/* The inside. */
scene_object *small_object(const small *s);
/* How many events of that kind the last step had, and the last of them. */
uint32_t small_events(const small *s, vbss_scene_event_kind kind, vbss_scene_event *event);

#endif
