/* Needles that pass through both sides of a fold at once.
 *
 * A needle that enters a wall at an oblique angle is excluded from contact with the wall beside
 * its tip. Where the wall is folded there, the axis may cross both sides of the fold before the
 * tip has passed the hole. The hole is one of the two crossings; the other becomes a second
 * hole. Otherwise the needle would continue along the wall and pass through it without a hole. */
#include "scene/tissue/tissue.h"
#include "scene/world/world.h"

/* Where an axis goes through a wall; no more of them are looked at. */
enum { CROSSINGS = 8 };
typedef struct crossing {
    suture_hole at;       /* triangle and barycentric coordinates */
    double arc, distance; /* arc length from the tip of the needle; distance from the hole, m */
} crossing;

static double distance_from_hole(const suture_hole *hole, const scene_body *wall_body,
                                 const suture_hole *at)
{
    const suture_wall wall = vbss_scene_wall_of(wall_body);
    const scene_wall_point wall_point =
        vbss_scene_wall_point(wall_body, at->triangle, at->barycentric);
    return vbss_max(vec3_distance(wall_point.now, vbss_hole_point(hole, &wall, wall.now)),
                    vec3_distance(wall_point.rest, vbss_hole_point(hole, &wall, wall.rest)));
}

/* Part of a capsule's axis beyond an arc length. */
static void remaining_axis(const scene_body *needle, uint32_t capsule, double from, vec3 axis[2])
{
    const needle_object *n = needle->rigid.needle;
    const pose at = vbss_scene_needle_frame(&needle->rigid, needle->rigid.body.now.pose);
    const double start = vbss_needle_vertex_arc(n, capsule),
                 end = vbss_needle_vertex_arc(n, capsule + 1);
    const vec3 first = pose_apply(at, vbss_needle_point(n, start));
    axis[1] = pose_apply(at, vbss_needle_point(n, end));
    axis[0] = vec3_lerp(first, axis[1], (from - start) / (end - start));
}

/* Lists the crossings of a needle with a wall, from the tip to an arc length. Crossings nearer
 * to each other than the wire's radius count as one: a side of two triangles has one in each. */
static uint32_t list_crossings(const scene_body *needle, const scene_body *wall_body, double to,
                               crossing *list)
{
    const needle_object *n = needle->rigid.needle;
    const suture_wall wall = vbss_scene_wall_of(wall_body);
    uint32_t count = 0;
    double from = 0.0, fraction;
    for (uint32_t i = 0; i < n->config.segment_count && from < to; i++) {
        const double end = vbss_needle_vertex_arc(n, i + 1);
        for (bool more = true; more && from < end && count < CROSSINGS;) {
            vec3 axis[2];
            remaining_axis(needle, i, from, axis);
            more = vbss_suture_find_wall_crossing(&wall, axis, &list[count].at, &fraction);
            if (more) {
                list[count].arc = from + fraction * (end - from);
                from = list[count++].arc + n->config.wire_radius;
            }
        }
        from = vbss_max(from, end);
    }
    return count;
}

static void pierce(scene_object *s, const scene_body *needle, const scene_body *wall_body,
                   const crossing *c)
{
    const suture_wall wall = vbss_scene_wall_of(wall_body);
    const pose at = vbss_scene_needle_frame(&needle->rigid, needle->rigid.body.now.pose);
    const vec3 direction =
        quat_rotate(at.orientation, vbss_needle_direction(needle->rigid.needle, c->arc));
    suture_hole made = c->at;
    made.needle = needle->number;
    made.wall = wall_body->number;
    made.is_outward = vbss_suture_is_outward(&wall, c->at.triangle, direction);
    made.arc = c->arc;
    made.max_arc = vbss_max(c->arc, wall.law->tip_length); /* the hole is open */
    vbss_scene_add_hole(s, &made, 0.0);
}

/* The crossing nearest to the hole is that of the hole itself. */
static void add_punctures_beside(scene_object *s, const suture_hole *hole)
{
    const scene_body *needle = vbss_scene_body(s, hole->needle);
    const scene_body *wall_body = vbss_scene_body(s, hole->wall);
    const double wire = needle->rigid.needle->config.wire_radius;
    const double reach =
        SCENE_EXCLUSION_ARC_RATIO * (wire + 0.5 * vbss_scene_wall_of(wall_body).law->thickness);
    const double mouth = vbss_max(reach, -SCENE_EXCLUSION_ARC_RATIO * hole->entry_arc);
    crossing list[CROSSINGS] = {0};
    const uint32_t count = list_crossings(needle, wall_body, hole->arc + mouth, list);
    uint32_t own = 0;
    for (uint32_t i = 0; i < count; i++) {
        list[i].distance = distance_from_hole(hole, wall_body, &list[i].at);
        own = list[i].distance < list[own].distance ? i : own;
    }
    for (uint32_t i = 0; i < count; i++) {
        if (i != own && list[i].distance < mouth &&
            !vbss_scene_is_in_other_hole(s, hole, list[i].arc)) {
            pierce(s, needle, wall_body, &list[i]);
        }
    }
}

void vbss_scene_find_fold_punctures(scene_object *s)
{
    for (uint32_t i = 0; i < s->config.hole_capacity; i++) {
        const suture_hole *hole = &s->holes[i];
        bool enters = vbss_scene_is_hole_active(s, hole) && hole->needle != 0 && hole->arc >= 0.0 &&
                      hole->arc < -SCENE_EXCLUSION_ARC_RATIO * hole->entry_arc;
        if (enters) {
            add_punctures_beside(s, hole);
        }
    }
}
