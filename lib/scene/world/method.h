/* What the method of a scene does. The table is chosen once, when a scene is created. */
#ifndef VBSS_SCENE_METHOD_H
#define VBSS_SCENE_METHOD_H

#include "base/stream.h"
#include "scene/world/scene_data.h"

struct scene_method {
    /* ---- life */

    /* State of the method, when the scene's arrays and its collision object are there; destroy_state follows also
     * when this fails. */
    vbss_result (*create_state)(scene_object *s);
    void (*destroy_state)(scene_object *s);

    /* Changes the configuration of the collision object that is about to be created. */
    void (*configure_collision)(const scene_object *s, vbss_collision_config *config);

    /* Prepares the scene for a drain, whose shape it has already. */
    vbss_result (*prepare_drain)(scene_object *s, const drain_object *added, uint32_t shape);

    /* A body has been added; one is about to be removed, and pins, grasps and holes of it are gone. */
    void (*add_body)(scene_object *s, const scene_body *b);
    void (*remove_body)(scene_object *s, uint32_t number);

    /* ---- a step */

    /* One step of h seconds. On failure the state is that before the step. */
    vbss_result (*step_scene)(scene_object *s, double h);

    /* Moves the jaws of a tool before a step, and releases what they open beyond. */
    void (*move_jaws)(scene_object *s, scene_body *tool, double h);

    /* After a step: adds contacts to the views, and their forces to the rigid bodies. */
    void (*publish_contacts)(scene_object *s);

    /* After a step: inserts the pairs of bodies that touch. */
    void (*list_touching_pairs)(scene_object *s);

    /* ---- grasps */

    /* Whether a grasp that is not released holds its thread; whether a tool with a needle in its jaws holds it. */
    bool (*holds_thread)(const scene_object *s, const scene_thread_grasp *g);
    bool (*holds_needle)(const scene_object *s, const scene_body *tool);

    /* The middle of what a grasp holds of a thread, m. */
    vec3 (*grasp_position)(const thread_object *t, const scene_thread_grasp *g);

    /* ---- snapshots */

    /* State of the method of a needle; whether state that was read is possible, when all bodies are read. */
    void (*serialise_needle)(vbss_stream *stream, scene_object *s, const scene_body *needle);
    bool (*is_valid_body)(const scene_object *s, const scene_body *b);

    /* The pin by which grasp `index` holds its node; NULL: the method has no such pins. */
    uint32_t *(*grasp_pin)(const scene_object *s, uint32_t index);

    /* ---- reports */

    /* Counters that only this method has, part of the state; NULL: it has none. */
    vbss_baseline_statistics *(*baseline_statistics)(const scene_object *s);

    bool has_separation_cache; /* the collision object has one */
    bool drives_tools;         /* graspers are driven bodies, else coupled ones */
    bool welds_pins;           /* pins on bodies that forces move are welds, else attachments */
    bool grasps_when_closed;   /* closed jaws grasp: one node of a thread, or a needle at angle 0 */
    bool accepts_holes;        /* hosts may make holes */
};
extern const scene_method vbss_scene_implicit; /* step/implicit_method.c */
extern const scene_method vbss_baseline_scene; /* defined in lib/baseline */

#endif
